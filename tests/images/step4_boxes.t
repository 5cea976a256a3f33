# Step 4's boxes: --blur boxes, three of them in a row, and running boxes in
# compute shaders, which are the same filter as a box of fragments.
use strict;
use warnings;
use Test::More;
use VSM;

my @bare = qw(--size 160x90 --map-size 128 --bleed-reduction 0);

# Every filter against its formula, whoever sums. A map with sides that no
# block divides; a box of almost the whole map; several layers.
for my $options (
    [qw(--blur-by compute --radius 1)],
    [qw(--blur-by compute --radius 8 --map-size 150x90)],
    [qw(--blur-by compute --radius 8 --moments central)],
    [qw(--blur-by compute --radius 63 --moments central)],
    [qw(--blur boxes --blur-by compute --radius 1)],
    [qw(--blur boxes --blur-by compute --radius 10 --map-size 150x90)],
    [qw(--blur boxes --blur-by compute --radius 7 --moments central)],
    [qw(--blur boxes --blur-by fragments --radius 7)],
    [qw(--blur boxes --blur-by fragments --radius 4 --moments central)],
    [qw(--blur boxes --format rg16f --downsample 2)],
    [qw(--blur boxes --radius 5 --mips --moments central --light point)],
  )
{
    note("@$options");
    my $dump = dump_run( 5, @bare, @$options );
    oracle( $_, $dump ) for qw(files stage);
    oracle( 'lower', $dump ) unless grep { $_ eq '--mips' } @$options;
}

# Two depths under the filter, however close: the lit share. A running sum of
# the whole line would have lost the smaller gaps.
for my $options (
    [qw(--scene edge:gap=0.1 --radius 12)],
    [qw(--scene edge:gap=1e-5 --radius 3 --moments central)],
    [qw(--scene edge:gap=1e-4 --radius 12 --moments central)],
    [qw(--scene edge:gap=1e-4 --radius 12 --moments central --blur boxes)],
  )
{
    oracle( 'edge', dump_run( 5, @bare, qw(--blur-by compute), @$options ) );
}

done_testing;
