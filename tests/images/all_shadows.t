# --shadows off: the same picture without anything in the light's way, and
# without a map: what a frame with shadows is compared with.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

of_steps( 1 .. 5 );

my @off = qw(--size 160x90 --map-size 64 --shadows off);

# What faces the light, and is in a spot's cone, has visibility 1, the rest 0;
# and the picture is shaded by it.
for my $words (
    [ 1, qw(--scene teapot) ],
    [ 2, qw(--scene stage --adaptive) ],
    [ 3, qw(--scene room) ],
    [ 4, qw(--scene avenue --splits 4) ],
    [ 5, qw(--scene teapot --mips --deferred) ],
  )
{
    my ( $step, @options ) = @$words;
    next if !is_chosen($step);
    my $dump = dump_run( $step, @off, @options );
    note("step $step @options");
    oracle( $_, $dump ) for qw(files stage shading);
    my @maps = grep { /^(?:depth|moments|blurred)/ } everything_below($dump);
    is( "@maps", '', "step $step: no map is written" );
}

# Nothing casts, or nothing faces the light: the same with shadows.
for my $words ( [ 1, 'empty' ], [ 2, 'empty' ], [ 5, 'unlit' ] ) {
    my ( $step, $scene ) = @$words;
    next if !is_chosen($step);
    same_files(
        "step $step, scene $scene: no shadow to leave out",
        (
            map { dump_run( $step, @off, '--scene', $scene, @$_ ) } [],
            [qw(--shadows on)]
        ),
        qw(picture visibility position normal)
    );
}

# No time goes into a map.
my $folder = dump_run( 5, @off );
my $run    = run( 5, @off, '--bench', 1, '--output', "$folder/timed.png" );
my @passes = $run->{out} =~ /^(\w+),[\d.]/mg;
is( "@passes", 'shading total', 'the only pass is the shading' );

done_testing;
