# The columns of results.csv, and what each means. The page and results.json
# carry the same list.
package Columns;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(@COLUMNS @CHAIN csv);

my %TRUTH = (
    pcf       => 'the same weights on ideal depths (same-weights PCF)',
    footprint => 'the exact visibility averaged over the filter\'s footprint '
      . '(footprint truth)',
    light => 'a single exact ray; of a soft technique, the visible share of '
      . 'the area light (light truth)',
);
my %ERROR = (
    pixels    => 'pixels counted',
    apart     => 'pixels not counted: silhouettes, N.L under 0.1',
    nonfinite => 'visibilities that are not finite; not counted',
    rmse      => 'root of the mean squared error',
    p99       => 'error that 99 % of the pixels do not exceed',
    max       => 'largest error',
    share     => 'share of the pixels with an error over 1/255',
    mean      => 'mean of the signed errors: under 0 it is too dark',
);
my %PASS = (
    map     => 'filling the shadow map',
    blur    => 'filtering the map',
    shading => 'shading the picture',
    total   => 'all passes of a frame',
);
my %TIME = (
    ms => 'median',
    q1 => 'first quartile',
    q3 => 'third quartile',
);

# The links of the error's chain: from one picture to the next, the first
# being light truth. The signed differences add up to program minus light
# truth on every pixel.
our @CHAIN = (
    [ footprint => 'the filter: footprint truth in place of light truth' ],
    [ pcf       => 'the map\'s texels: same-weights PCF' ],
    [ mean      => 'comparing with a filtered depth (steps 3 and 4)' ],
    [ chebyshev => 'Chebyshev\'s bound, exact: light bleeding' ],
    [ floor     => 'the minimum variance, and variance bias' ],
    [ reduction => 'the light-bleeding reduction' ],
    [ format    => 'the number format of the stored moments' ],
    [ program   => 'what is left to the program: rasteriser, bias, lookup' ],
);
my %CHAIN = map { @$_ } @CHAIN;

our @COLUMNS = (
    [ scene     => 'name of the scene' ],
    [ technique => 'name of the technique' ],
    [ label     => 'technique, width, and the map where it is not the usual' ],
    [ step      => 'the program: 1 to 5' ],
    [ width     => 'of the filter, texels of the map' ],
    [ map       => 'side of the shadow map, texels' ],
    [ options   => 'the program\'s options, separated by spaces' ],
    [ map_bytes => 'memory of all maps, bytes' ],
    [ rounds    => 'runs of the program for its times' ],
    [ frames    => 'frames timed in all' ],
    [ clock     => 'the clock of the times' ],
    [
        front => '1: no point of the scene is both clearly faster and no '
          . 'more wrong (footprint truth)'
    ],
    (
        map {
            my $truth = $_;
            map {
                [ "${truth}_$_" =>
                      "visibility against $TRUTH{$truth}: $ERROR{$_}" ]
            } qw(pixels apart nonfinite rmse p99 max share mean)
        } qw(pcf footprint light)
    ),
    [
        area_rmse => 'RMSE of the visibility against the visible share of an '
          . 'area light, of the soft techniques and those beside them'
    ],
    [
            butteraugli => 'perceptual difference of the visibility, as a grey '
          . 'picture, to footprint truth (of a soft technique light truth): '
          . 'Butteraugli\'s 3-norm, 1 is just noticeable'
    ],
    (
        map {
            my $link = $_->[0];
            map { [ "chain_${link}_$_" => "of $CHAIN{$link}: $ERROR{$_}" ] }
              qw(rmse mean)
        } @CHAIN
    ),
    (
        map {
            my $pass = $_;
            map {
                [ "${pass}_$_" => "milliseconds of $PASS{$pass}: $TIME{$_}" ]
            } qw(ms q1 q3)
        } qw(map blur shading total)
    ),
    [ missing => 'why the row has gaps; empty: it is complete' ],
);

sub quoted {
    my ($value) = @_;
    $value = join ' ', @$value if ref $value;
    return $value =~ /[",\n]/ ? '"' . $value =~ s/"/""/gr . '"' : $value;
}

sub csv {
    my @points = @_;
    my @names  = map { $_->[0] } @COLUMNS;
    my $text   = join( ',', @names ) . "\n";
    for my $point (@points) {
        $text .=
          join( ',', map { quoted( $point->{$_} // '' ) } @names ) . "\n";
    }
    return $text;
}

1;
