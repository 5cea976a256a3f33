# Step 5's summed-area table with a box of each pixel's own width.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256 --bleed-reduction 0 --sat);
my @wide  = ( @small, qw(--sat-width adaptive) );

# A map that is coarse for the picture, so that widths differ; one that is fine
# where it is far; another light, layers, and what else changes the table.
for my $options (
    [qw(--map-size 128)],
    [qw(--scene fence --radius 5 --min-variance 1e-5)],
    [qw(--scene stage --map-size 64 --downsample 2)],
    [qw(--scene avenue --splits 2)],
  )
{
    oracle( 'stage', dump_run( 5, @wide, @$options ) );
}

sub same_width {
    my ( $what, @options ) = @_;
    my @dumps =
      map { dump_run( 5, @$_, @options ) } \@small,
      [ @small, qw(--sat-width adaptive) ];
    note($what);
    oracle( 'compare', ( map { "$_/visibility.exr" } @dumps ), 'max=0' );
    return;
}

# The width is at least a texel and at most what was asked for: so where these
# are one number, and where every texel is wider than that on the screen, it is
# the fixed width.
same_width( 'a radius of 0', qw(--radius 0) );
same_width( 'texels of many pixels', qw(--scene edge --map-size 32 --radius 1) );

# Where a pixel is wider than two texels, the box is one texel. The two tables
# differ in their integers' step, which is why this is not to the last bit: by
# 2^-27 of a moment, against a variance of 0.0025 where the planes meet.
my @far = qw(--size 16x9 --map-size 2048 --scene edge);
note('pixels of many texels');
oracle(
    'compare',
    (
        map { dump_run( 5, @small, @far, @$_ ) . '/visibility.exr' }
          [qw(--sat-width adaptive)],
        [qw(--radius 0)]
    ),
    'max=2e-3'
);

done_testing;
