# Text and numbers as the page has them.
package Html;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(escaped number names_of);

sub escaped {
    my ($text) = @_;
    my %entity =
      ( '&' => '&amp;', '<' => '&lt;', '>' => '&gt;', '"' => '&quot;' );
    return $text =~ s/([&<>"])/$entity{$1}/gr;
}

# Three significant digits, without an exponent where that is short.
sub number {
    my ($value) = @_;
    return ''         if !defined $value || $value eq '';
    return $value + 0 if $value == 0;
    return sprintf '%.1e', $value if abs $value < 1e-3;
    my $digits = 2 - int( log( abs $value ) / log(10) + 100 ) + 100;
    return sprintf '%.*f', $digits > 0 ? $digits : 0, $value;
}

# The different values of a column, in the points' order.
sub names_of {
    my ( $column, @points ) = @_;
    my %seen;
    return grep { !$seen{$_}++ } map { $_->{$column} } @points;
}

1;
