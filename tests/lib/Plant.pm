# Planting mistakes in a text.
package Plant;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(planted);

# The text of a file with, of each pair, the first place that holds the one
# replaced by the other. Dies where a file does not hold it any more.
sub planted {
    my ( $file, $text, @pairs ) = @_;
    while ( my ( $from, $to ) = splice @pairs, 0, 2 ) {
        my $place = index $text, $from;
        $place >= 0 or die "$file does not hold '$from' any more\n";
        substr( $text, $place, length $from ) = $to;
    }
    return $text;
}

1;
