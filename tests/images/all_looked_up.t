# What the picture needs of each map, as base/leave_out finds it from the scene
# alone, against the pixels that look it up: none outside of its rectangle, and
# not many more texels than they need.
use strict;
use warnings;
use Test::More;
use VSM;

of_steps( 1 .. 5 );

my @small = qw(--size 320x180 --map-size 256);

# How many times the texels between the outermost lookups: 1, where nothing else
# hides what reaches furthest out in the map. Hidden surfaces count as seen, and
# so does the box around a dense mesh.
for my $case (
    [ 1,   qw(empty) ],
    [ 1,   qw(grazing) ],
    [ 1,   qw(unlit) ],
    [ 1,   qw(offstage) ],
    [ 1,   qw(stage) ],
    [ 1.5, qw(room) ],
    [ 1,   qw(crowd) ],
    [ 1,   qw(avenue) ],
    [ 1.1, qw(avenue --splits 4) ],
    [ 1.5, 'avenue:turn=50,walk=30', qw(--splits 8) ],
    [ 1,   qw(empty --light point) ],
    [ 1.1, qw(empty --light spot) ],
    [ 1.5, qw(offstage --light point) ],
    [ 1,   'teapot:offset=1e6,scale=0.01' ],
    [ 1,   'empty:elevation=90' ],
  )
{
    my ( $most, $scene, @options ) = @$case;
    oracle( 'looked-up',
        dump_run( 1, @small, '--scene', $scene, @options ), "most=$most" );
}

# --show plan: the pixels that look a map up, and those that need not.
for my $case (
    [ 'most=1', 1, 'room:turn=-60' ],
    [ 'most=2', 2, 'avenue:turn=20', qw(--splits 4) ],
    [ 'most=1', 5, qw(stage --deferred) ],
    [ 'most=1', 3, qw(empty --keep-all) ],
    [ 'none=1', 4, 'empty' ],
    [ 'none=1', 5, 'offstage' ],
    [ 'none=1', 1, qw(teapot --shadows off) ],
  )
{
    my ( $what, $step, $scene, @options ) = @$case;
    oracle(
        'plan',
        dump_run(
            $step, @small, '--scene', $scene, '--show', 'plan', @options
        ),
        $what
    );
}

done_testing;
