# `make lesson` copies a step's lesson alone: without techniques, and without
# the rooms of the ground floor that no lesson needs. The copy builds by itself,
# is small enough to read, and draws the bytes of the default picture.
use strict;
use warnings;

use File::Compare qw(compare);
use File::Path    qw(make_path);
use File::Temp    qw(tempdir);
use Test::More;
use VSM;

my $work = tempdir( CLEANUP => 1 );
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES STEP DEPS BUILD)};
delete @ENV{qw(CFLAGS CXXFLAGS LDFLAGS)};

sub make { return command( '/usr/bin/env', 'make', @_ ) }

# Lines of C and GLSL that a copy has at most.
my %MOST = ( 1 => 5200, 2 => 5300, 3 => 5340, 4 => 5560, 5 => 5720 );

# What no lesson knows.
my $STRANGE = qr{/techniques/|/base/(?:leave_out|seams|scenes|measure)/};

sub check_files {
    my ( $step, $folder ) = @_;
    my $run = make( '-C', root(), 'lesson', "STEP=$step", "DIR=$folder" );
    is( $run->{status}, 0, "step $step: make lesson" )
      or diag( $run->{out}, $run->{err} );
    my @files = grep { -f "$folder/$_" } everything_below($folder);
    my @own   = grep { compare( "$folder/$_", root() . "/$_" ) } @files;
    is( "@own", 'Makefile', "step $step: one file is not one of the tree" );
    cmp_ok( slurp("$folder/Makefile") =~ tr/\n//,
        '<=', 20, "step $step: and short" );
    is( join( ' ', grep { /$STRANGE/ } @files ),
        '', "step $step: nothing of techniques" );
    my $lines = 0;
    $lines += slurp("$folder/$_") =~ tr/\n//
      for grep { /\.(?:c|h|cpp|glsl|vert|geom|frag|comp)$/ } @files;
    cmp_ok( $lines, '<=', $MOST{$step}, "step $step: $lines lines" );
    return;
}

# The GL loader and the ground floor are the same for all: made once.
sub check_build {
    my ( $step, $folder ) = @_;
    my $floor = 'build/obj/step1_shadowmap/base';
    if ( $step > 1 ) {
        make_path("$folder/$floor");
        command( '/bin/cp', '-r', "$work/1/build/glad", "$folder/build" );
        command( '/bin/cp', '-r', "$work/1/$floor/.", "$folder/$floor" );
    }
    my $run = make( '-C', $folder, qw(-j2 DEPS=no CXXFLAGS=-O0 CFLAGS=-O0) );
    is( $run->{status}, 0, "step $step: it builds" )
      or diag( $run->{out}, $run->{err} );
    is( $run->{err}, '', "step $step: without a warning" );
    return;
}

# command() and not run(): VSM_SHADERS would reach only one of the two.
sub check_run {
    my ( $step, $copy ) = @_;
    my @pictures = ( "$work/ours.png", "$work/alone.png" );
    my @small    = qw(--size 160x90 --output);
    command( program($step), @small, $pictures[0] );
    my $run = command( $copy, @small, $pictures[1] );
    is( $run->{err}, '', "step $step: it draws" );
    is( compare(@pictures), 0, "step $step: the default picture's bytes" );
    my ( $few, $all ) =
      map { command( $_, '--list-scenes' )->{out} } $copy, program($step);
    for my $name ( $few =~ /^(\w+)  /mg ) {
        like( $all, qr/^$name  /m, "step $step: scene $name is known" );
        my $drawn = command( $copy, '--scene', $name, @small, $pictures[1] );
        is( $drawn->{status}, 0, "step $step: and drawn" );
    }
    like( $few, qr/^teapot  /m, "step $step: and one is the teapot" );
    unlike( $few, qr/^room  /m, "step $step: it lists what it can draw" );
    for my $option ( '--plan', '--light', '--bench', '--moments' ) {
        stops { command( $copy, $option, 'x' ) } 2, [qr/unknown.*$option/],
          "step $step: $option is none of its options";
    }
    return;
}

# Each of the options that it keeps.
sub check_options {
    my ( $step, $copy ) = @_;
    my $help = command( $copy, '--help' )->{out};
    like( $help, qr/^  --$_ /m, "step $step: --$_" )
      for qw(scene list-scenes size map-size output show dump shaders window);
    stops { command( $copy, '--shaders', "$work/none" ) } 2,
      [qr/no such directory/], "step $step: --shaders names a folder";
    my $dump = "$work/dump$step";
    command( $copy, '--dump', $dump, '--size', '32x18' );
    for my $name (qw(image receiver visibility)) {
        ok( -s "$dump/$name.exr", "step $step: --dump writes $name.exr" );
    }
    return;
}

for my $step ( 1 .. 5 ) {
    my $folder = "$work/$step";
    my $copy   = "$folder/build/" . program_name($step);
    check_files( $step, $folder );
    check_build( $step, $folder );
    check_run( $step, $copy );
    check_options( $step, $copy );
}

my $run = make( '-C', root(), 'lesson', "DIR=$work/1" );
like( $run->{err}, qr/holds files/, 'a folder with files stays as it is' );
isnt( $run->{status}, 0, 'and that is an error' );
$run = make( '-C', root(), 'lesson' );
like( $run->{err}, qr/say where: make lesson/, 'a folder has to be named' );

done_testing;
