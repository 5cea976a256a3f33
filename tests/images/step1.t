# Step 1: the map against ray casting, the comparison against its formula.
use strict;
use warnings;
use Test::More;
use VSM;

my @small = qw(--size 320x180 --map-size 256);

for my $scene (qw(teapot edge bleed empty)) {
    my $dump = dump_run( 1, '--scene', $scene, @small );
    oracle( $_, $dump ) for qw(files stage matrix rays);
}
oracle( 'edge', dump_run( 1, '--scene', 'edge', @small ) );

# A map that is neither square nor a power of two; other biases, none, and
# one that is far too large; a light near the horizon; a world elsewhere.
for my $options (
    [qw(--map-size 300x180)],
    [qw(--bias 0 --slope-bias 0)],
    [qw(--bias 0.02 --slope-bias 3)],
    [qw(--scene teapot:elevation=20)],
    [ '--scene', 'teapot:offset=1000,scale=0.01' ],
  )
{
    my $dump = dump_run( 1, @small, @$options );
    oracle( $_, $dump ) for qw(files stage matrix);
}

done_testing;
