# Each step is a program of its own: `make standalone` copies exactly the
# files of its list, and the copy builds and draws the same without the rest
# of the tree, in a folder of any name. And what else the Makefile promises
# about a step.
use strict;
use warnings;

use File::Compare qw(compare);
use File::Path    qw(make_path);
use File::Temp    qw(tempdir);
use Lists;
use Test::More;
use VSM;

my $work = tempdir( CLEANUP => 1 );
$work .= '/it\'s my copy $x #1 (b) [c]{d} 100% "q" & \\t;*';
mkdir $work;

# Optimising does not change the picture, only how long the compiler takes.
my @quick = qw(-j2 DEPS=no CXXFLAGS=-O0 CFLAGS=-O0);

sub step_list { return made_list( program_name(@_) ) }

# A lesson is its step without techniques.
sub lesson { return grep { !m{/techniques/} } step_list(@_) }

my @base = made_list('base');

sub check_copy {
    my ( $step, $folder ) = @_;
    my $name = program_name($step);
    my $run  = make( '-C', root(), 'standalone', "STEP=$step", "DIR=$folder" );
    is( $run->{status}, 0, "step $step: make standalone" )
      or diag( $run->{out}, $run->{err} );
    my %expected =
      map { $_ => 1 } step_list($step), @base, 'Makefile',
      map { m{^(step\w+)/} ? "$1/Makefile" : () } step_list($step);
    my @files = grep { -f "$folder/$_" } everything_below($folder);
    is_deeply( \@files, [ sort keys %expected ],
        "step $step: the copy is the list, the ground floor and Makefiles" );
    my @changed = grep { compare( "$folder/$_", root() . "/$_" ) }
      grep { $_ ne 'Makefile' } @files;
    is( "@changed", '', "step $step: the copies are true" );
    return;
}

# Step 4 is built from its own folder, the others from the copy's top.
sub check_build {
    my ( $step, $folder ) = @_;
    my $where = $step == 4 ? "$folder/" . program_name($step) : $folder;
    my $run   = make( '-C', $where, @quick );
    is( $run->{status}, 0, "step $step: the copy builds" )
      or diag( $run->{out}, $run->{err} );
    is( $run->{err}, '', "step $step: without a warning" );
    my $again = make( '-C', $where, @quick );
    unlike( $again->{out}, qr/compile|link|glad/,
        "step $step: a second make has nothing to do" );
    is( $again->{status}, 0, "step $step: and is content" );

    # The top and the folder make the same objects by other names.
    my $other = $step == 4 ? $folder : "$folder/" . program_name($step);
    unlike( make( '-C', $other, '-n', @quick )->{out},
        qr/compile|link/, "step $step: nor has one from elsewhere" );
    utime undef, undef, "$folder/step1_shadowmap/shadow_map.h";
    like( make( '-C', $other, '-n', @quick )->{out},
        qr/compile .*main\.c/, "step $step: it knows what a header changes" );
    return;
}

# command() and not run(): VSM_SHADERS would reach only one of the two.
sub check_picture {
    my ( $step, $copy ) = @_;
    my $ours  = "$work/ours$step.png";
    my $alone = "$work/alone$step.png";
    command( program($step), qw(--size 160x90 --output), $ours );
    my $run = command( $copy, qw(--size 160x90 --output), $alone );
    is( $run->{err}, '', "step $step: the copy draws" );
    is( compare( $ours, $alone ),
        0, "step $step: the copy's picture has the same bytes" );
    return;
}

# The copy has its own shaders and reads them when it runs. Without the step's
# own ones it stops, in whatever order it reads them.
sub check_missing_shader {
    my ( $step, $folder, $copy ) = @_;
    my $shaders = program_name($step) . '/shaders';
    unlink "$folder/$_" for grep { m{^$shaders/} } step_list($step);
    mkdir "$folder/empty";
    chdir "$folder/empty";
    stops { command( $copy, qw(--size 16x9 --output a.png) ) } 1,
      [qr{missing.*$shaders/\w+}], "step $step: a missing shader is named";
    chdir '/';
    return;
}

for my $step ( 1 .. 5 ) {
    my $folder = "$work/mine$step";
    my $copy   = "$folder/build/" . program_name($step);
    check_copy( $step, $folder );

    # The GL loader and the ground floor are the same for all: made once.
    if ( $step > 1 ) {
        my $floor = 'build/obj/step1_shadowmap/base';
        make_path("$folder/$floor");
        command( '/bin/cp', '-r', "$work/mine1/build/glad", "$folder/build" );
        command( '/bin/cp', '-r', "$work/mine1/$floor/.", "$folder/$floor" );
    }
    check_build( $step, $folder );
    check_picture( $step, $copy );
    check_missing_shader( $step, $folder, $copy );
}

# The difference of two lessons: main.c as a diff, and the files by name.
for my $step ( 2 .. 5 ) {
    my ( $old, $new ) = map { program_name($_) } $step - 1, $step;
    my $run = make( '-C', root(), '-s', 'diff', "STEP=$step" );
    is( $run->{status}, 0, "make diff STEP=$step" ) or diag( $run->{err} );
    like( $run->{out}, qr{^--- $old/main\.c\n\+\+\+ $new/main\.c\n\@\@ }m,
        "make diff STEP=$step shows main.c" );
    my %before = map { $_ => 1 } lesson( $step - 1 );
    my %now    = map { $_ => 1 } lesson($step);
    my @new    = grep { !$before{$_} && $_ ne "$new/main.c" } keys %now;
    my @gone   = grep { !$now{$_} && $_ ne "$old/main.c" } keys %before;
    is_deeply( [ sort $run->{out} =~ /^new: (.*)/mg ],
        [ sort @new ], "make diff STEP=$step names what is new" );
    is_deeply( [ sort $run->{out} =~ /^gone: (.*)/mg ],
        [ sort @gone ], "make diff STEP=$step names what is gone" );
}
my @build = $ENV{VSM_BUILD} ? "BUILD=$ENV{VSM_BUILD}" : ();
my $again = make( '-C', root(), 'programs', 'DEPS=no', @build );
unlike( $again->{out}, qr/compile|link|glad/,
    'make has nothing to do after make' );

done_testing;
