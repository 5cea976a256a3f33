# What a depth bias cures and what it costs, against ray casting.
#
# Scene empty is a floor on which the depth changes by g = 0.0063 of its range
# from one row of these maps' texels to the next, and not along a row.
use strict;
use warnings;
use Test::More;
use VSM;

of_steps( 1, 2 );

sub bias_is {
    my ( $what, $step, $options, @shares ) = @_;
    return if !is_chosen($step);
    note("step $step: $what");
    my @small = qw(--size 320x180 --map-size 256);
    oracle( 'bias', dump_run( $step, @small, @$options ), @shares );
    return;
}

my @none = qw(--bias 0 --slope-bias 0);
my @post = qw(--bias 0.005 --slope-bias 0);

# Without a bias a receiver is dark where its texel's centre is nearer to the
# light: in half of the texel. 57,600 pixels see every place in it alike, but
# for what the two rasters have in common.
bias_is( 'half of a bare texel is dark',
    1, [ qw(--scene empty), @none ], qw(acne-least=0.45 acne-most=0.55) );

# Of two taps on either side one is dark: at most 4 of 7 rows are lit.
bias_is( 'no window is without acne',
    2, [ qw(--scene empty), @none ], qw(acne-least=1) );

# The BUas article's 0.005 is more than the g / 2 that one texel needs. The third row
# of a window is at least 2.5 g = 0.016 away.
bias_is( '0.005 is enough for a texel on this floor',
    1, [ qw(--scene empty), @post ], qw(acne-most=0) );
bias_is( '0.005 is not enough for 7 x 7',
    2, [ qw(--scene empty), @post ], qw(acne-least=1) );
# 0.001: silhouettes that the texels' centres do not show, as in `rays`.
bias_is( 'the slope alone is enough', 2, [qw(--bias 0)], 'acne-most=0.001' );

# An occluder 0.1 of the range above the floor, both perpendicular to the
# light: their depths are constant.
for ( [ 0.099, 'lost-most=0' ], [ 0.101, 'lost-least=1' ] ) {
    my ( $bias, $share ) = @$_;
    my @options = ( qw(--scene edge --slope-bias 0 --bias), $bias );
    bias_is( "a bias of $bias and a gap of 0.1", 2, \@options, $share );
}

done_testing;
