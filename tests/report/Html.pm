# Text and numbers as the page has them.
package Html;

use strict;
use warnings;

use Exporter qw(import);
use POSIX    qw(floor);

our @EXPORT_OK = qw(escaped number names_of);

sub escaped {
    my ($text) = @_;
    my %entity =
      ( '&' => '&amp;', '<' => '&lt;', '>' => '&gt;', '"' => '&quot;' );
    return $text =~ s/([&<>"])/$entity{$1}/gr;
}

# So many significant digits, three if nothing is said; without an exponent
# where that is short.
sub number {
    my ( $value, $digits ) = @_;
    return ''         if !defined $value || $value eq '';
    return $value + 0 if $value == 0;
    return sprintf '%.1e', $value if abs $value < 1e-3;
    my $after = ( $digits // 3 ) - 1 - floor( log( abs $value ) / log(10) );
    return sprintf '%.*f', $after > 0 ? $after : 0, $value;
}

# The different values of a column, in the points' order.
sub names_of {
    my ( $column, @points ) = @_;
    my %seen;
    return grep { !$seen{$_}++ } map { $_->{$column} } @points;
}

1;
