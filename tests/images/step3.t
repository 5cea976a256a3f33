# Step 3: two moments per texel, compared with the first.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);

for my $scene (qw(teapot edge bleed empty)) {
    my $dump = dump_run( 3, '--scene', $scene, @small );
    oracle( $_, $dump ) for qw(files stage matrix rays);
}
for my $options ( [qw(--map-size 300x180)], [qw(--bias 0.02 --slope-bias 0)] )
{
    oracle( 'stage', dump_run( 3, @small, @$options ) );
}

same_channel(
    'the mean of one texel is step 1\'s depth',
    dump_run( 1, @small ) . '/depth.0.exr',
    dump_run( 3, @small ) . '/moments.0.exr'
);

done_testing;
