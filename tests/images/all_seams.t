# Where two faces of a point light's cube meet, the picture is no more wrong
# than elsewhere.
#
# What may differ there: a face looks s texels beyond its edge, at the tangent
# 1 + s / k with k texels to a tangent of 1; its neighbour sees the same ray at
# 1 / (1 + s / k), so s and its own s' differ by s^2 / k at most. Along the
# edge, at the place y in [-1, 1] of it, the other face divides by the other
# coordinate, which shears the kernel by y. So a box kernel of half width r sees
# a straight shadow edge differently by
#   r / (2 k)  from s^2 / k over the box's height 1 / (2 r), and
#   y / 8      from the shear: a ramp against the same ramp over a box of y r
# at most, in visibility: 0.02 in the middle of an edge and 0.15 in a corner of
# the cube, for r = 4.5 and k = 111 (a map of 256). Each face's own footprint
# truth takes this in: a face is compared with what its own kernel should see.
# What is left is what a filter does anywhere, unless it reads beyond the
# border that each face has around its 90 degrees.
use strict;
use warnings;
use Test::More;
use VSM;

of_steps( 2, 5 );

my @room = qw(--scene room --size 320x180 --map-size 256);

# 99th percentile of |error| against footprint truth: {rest}, {seam04}, ...
sub percentiles {
    my ($dump) = @_;
    my @words  = ( 'errors', $dump, 'rays=64', 'seams=1' );
    my $run    = ask_oracle(@words);
    my %p99;
    for ( split /\n/, $run->{out} ) {
        my ( $name, $pixels, $p99 ) = ( split /,/ )[ 0, 1, 5 ];
        $p99{$1} = $p99 if $name =~ /^footprint[.](\w+)/ && $pixels > 0;
    }
    return \%p99;
}

for my $options (
    [5],
    [2],
    [ 5, qw(--radius 8) ],
    [ 5, '--mips' ],
  )
{
    my ( $step, @options ) = @$options;
    next if !is_chosen($step);
    my $p99  = percentiles( dump_run( $step, @room, @options ) );
    my $rest = delete $p99->{rest};
    ok( keys %$p99 >= 10, "step $step @options: ten edges are in the picture" );
    for my $seam ( sort keys %$p99 ) {
        my $text = sprintf '%.3g, at most twice %.3g', $p99->{$seam}, $rest;
        ok( $p99->{$seam} <= 2 * $rest, "step $step @options, $seam: $text" );
    }
}

# Each level as the formula says, up to the last that stays within the border;
# the wide blur leaves fewer of them, and coarse pixels ask for more. Taps along
# a pixel stay within the border too.
for my $options ( grep { is_chosen(5) } [], [qw(--radius 6)],
    [qw(--anisotropy 16)] )
{
    my @coarse = qw(--size 80x45 --map-size 512 --mips --bleed-reduction 0);
    oracle( 'stage', dump_run( 5, qw(--scene room), @coarse, @$options ) );
}

done_testing;
