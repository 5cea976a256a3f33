# How a time grows with what it depends on: t = c x^p.
package Growth;

use strict;
use warnings;

use Exporter   qw(import);
use List::Util qw(sum);

our @EXPORT_OK = qw(exponent);

# p of pairs [x, t]: the slope of the straight line with the least squared
# distances through their logarithms. Nothing where all x are the same.
sub exponent {
    my @points = map {
        [ map { log } @$_ ]
    } @_;
    return unless @points;
    my ( $x, $t ) = map {
        my $axis = $_;
        sum( map { $_->[$axis] } @points ) / @points
    } 0, 1;
    my $across = sum( map { ( $_->[0] - $x )**2 } @points );
    return unless $across > 0;
    return sum( map { ( $_->[0] - $x ) * ( $_->[1] - $t ) } @points ) / $across;
}

1;
