# Step 2: the mean of n x n comparisons.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);

for my $scene (qw(teapot edge bleed empty)) {
    my $dump = dump_run( 2, '--scene', $scene, @small );
    oracle( $_, $dump ) for qw(files stage matrix rays);
}
for my $kernel ( 1, 3, 15 ) {
    my @options = ( @small, '--kernel', $kernel );
    oracle( 'stage', dump_run( 2, @options ) );
    oracle( 'edge', dump_run( 2, '--scene', 'edge', @options ) );
}
oracle( 'stage', dump_run( 2, qw(--size 320x180 --map-size 300x180) ) );

same_files( 'kernel 1 is step 1', dump_run( 1, @small ),
    dump_run( 2, @small, qw(--kernel 1) ), qw(picture visibility depth.0) );

# A disc of 32 taps in place of the grid.
for my $kernel ( 1, 3, 15 ) {
    my @options = ( @small, '--kernel', $kernel );
    oracle( 'stage', dump_run( 2, @options, qw(--pattern poisson) ) );
}
oracle( 'stage', dump_run( 2, qw(--scene stage --pattern poisson), @small ) );
my @edge = ( qw(--scene edge --kernel 15), @small );
my $disc = dump_run( 2, @edge, qw(--pattern poisson) );
oracle( 'stage', $disc );
oracle( 'disc', $disc, 'grid=' . dump_run( 2, @edge ) );

done_testing;
