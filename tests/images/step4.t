# Step 4: the filtered moments against one two-dimensional kernel.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);

for my $scene (qw(teapot edge bleed empty)) {
    my $dump = dump_run( 4, '--scene', $scene, @small );
    oracle( $_, $dump ) for qw(files stage matrix rays);
}
for my $options (
    [qw(--radius 1)],
    [qw(--radius 8)],
    [qw(--downsample 2)],
    [qw(--downsample 4 --radius 2)],
    [qw(--downsample 2 --radius 0)],
    [qw(--map-size 300x180)],
    [qw(--map-size 32 --radius 15)],
  )
{
    my $dump = dump_run( 4, @small, @$options );
    oracle( $_, $dump ) for qw(files stage);
}

my $step3 = dump_run( 3, @small );
for my $off ( [qw(--radius 0)], [qw(--blur none)] ) {
    same_files( "@$off is step 3",
        $step3, dump_run( 4, @small, @$off ),
        qw(picture visibility moments.0) );
}

done_testing;
