# stdout is a place to write to like any other: what does not get there is an
# error, and what is printed is true.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

my @small = qw(--size 16x9);

# A command through sh, which redirects: sh -c '"$@" >...' sh WORDS.
sub redirected {
    my ( $where, @words ) = @_;
    return command( '/bin/sh', '-c', "\"\$@\" $where", 'sh', @words );
}


for my $step ( 1, 5 ) {
    for my $words ( ['--help'], ['--list-scenes'], ['--print-shader'],
        ['--plan'], [qw(--bench 1 --redraw)], [qw(--output a.png)] )
    {
        stops {
            my $run = redirected( '>/dev/full', program($step), @small, @$words );
            unlink 'a.png';
            return $run;
        }
        1, [qr/cannot write to stdout: (?:No space|a part)/], "step $step, @$words, full";
    }
}
for my $words ( ['--help'], ['--plan'], [qw(--output a.png)] ) {
    stops {
        my $run = redirected( '>&-', program(1), @small, @$words );
        unlink 'a.png';
        return $run;
    }
    1, [qr/cannot write to stdout: Bad file/], "@$words, closed";

    # The pipe's one reader has gone before the program starts.
    stops {
        my $run = command(
            '/bin/sh', '-c',
            '{ sleep 0.2; "$@"; echo $? >status; } | :',
            'sh', program(1), @small, @$words
        );
        $run->{status} = slurp('status') + 0;
        unlink 'a.png', 'status';
        return $run;
    }
    1, [qr/cannot write to stdout: Broken pipe/], "@$words, nobody reads";
}

# Else the first file that is opened would be stdout, and hold what is printed.
my $run  = run( 1, @small, qw(--output right.png) );
my @none = ( '<&- >&-', '<&- 2>&-', '<&- >&- 2>&-' );
for my $closed (@none) {
    $run = redirected( $closed, program(1), @small, qw(--output a.png) );
    ok( slurp('a.png') eq slurp('right.png'), "$closed: the picture is whole" );
    unlink 'a.png';
}

# Times of a map that is kept are not those of drawing one.
$run = run( 5, @small, qw(--bench 1) );
like( $run->{err}, qr/\A[^\n]*map was kept[^\n]*--redraw[^\n]*\n\z/,
    '--bench says in one line that the map was kept' );
for my $words ( ['--redraw'], ['--keep-all'], [qw(--move teapot)],
    [qw(--shadows off)] )
{
    $run = run( 5, @small, qw(--bench 1), @$words );
    is( $run->{err}, '', "--bench 1 @$words: no word of it" );
}

# The picture's program, as the driver is given it: each stage begins with its
# version and the constants.
sub printed_files {
    my ( $constants, @words ) = @_;
    my $run   = run( @words, '--print-shader' );
    my @names = $run->{out} =~ /^\/\/ ---- (.*) ----$/mg;
    my ( $expected, $begins ) = ( '', 1 );
    for my $name (@names) {
        $expected .= '// ==== '
          . ( $name =~ /vert\z/ ? 'vertex' : 'fragment' )
          . " shader ====\n\n#version 330 core\n$constants\n\n"
          if $begins;
        $expected .= "// ---- $name ----\n\n" . slurp( root() . "/$name" ) . "\n";
        $begins = $name =~ /(?:vert|frag)\z/;
    }
    is( $run->{status} . $run->{err}, '0', "step @words: --print-shader" );
    is( $run->{out}, $expected, "step @words: every file, as it is" );
    return @names;
}

my @names = printed_files( 'const int kernel = 7;', 2 );
like( "@names", qr{\A\S+/scene.vert .*/pcf.glsl .*/scene.frag\z},
    'the files of both stages in their order' );
@names = printed_files( '', qw(3 --moments central) );
like( "@names", qr{/between_central.glsl}, 'what a technique adds' );
unlike( "@names", qr{lookup_bilinear}, 'and not what it replaces' );
ok( !-e 'out', 'and draws nothing' );

done_testing;
