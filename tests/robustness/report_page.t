# The page of `make report` in a browser: it sorts, its sliders move, nothing
# is asked of a network, and nothing goes wrong on the console. VSM_BROWSER=yes
# makes a missing Chromium a failure.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;
use Browser;

my $lacking = Browser::lacking();
if ($lacking) {
    die "$lacking\n" if $ENV{VSM_BROWSER};
    plan skip_all => "the report's page is not looked at: $lacking";
}

my $folder = tempdir( CLEANUP => 1 );
{
    local $ENV{REPORT}     = 'tiny';
    local $ENV{REPORT_OUT} = $folder;
    local $VSM::SECONDS    = 600;       # a dozen commands, of a minute each
    my $run = command( $^X, root() . '/tests/report/report.pl' );
    is( $run->{status}, 0, 'a small report' ) or diag( $run->{err} );
}
my $page = slurp("$folder/index.html");
my $bare = $page =~ s/data:image[^"]*//gr;
my @outside =
  grep { !m{^http://www\.w3\.org/} } $bare =~ m{((?:https?:)?//[^\s"'<>)]+)}g;
is( "@outside", '', 'the page names nothing that is elsewhere' );
like( $page, qr/off by\s0\.062 in a pixel/, 'sqrt(4 / 4) / 16 of 16 rays' );
unlike( $page, qr/\{\{/, 'no gap in the template is left open' );

my $browser = Browser->new( 1280, 900 );
$browser->open_file("$folder/index.html");
my $LOADED = <<'END';
return performance.getEntriesByType("resource").map((entry) => entry.name)
    .filter((name) => !name.startsWith("data:"));
END
is( "@{ $browser->js($LOADED) }", '', 'the page asks for nothing else' );

# --- in short ----------------------------------------------------------------

my $SHORT = 'return Array.from(document.querySelectorAll("#short tbody tr"),'
  . '(row) => row.cells[0].textContent)';
is( "@{ $browser->js($SHORT) }", 'edge', 'the scenes in short' );

# --- the table ---------------------------------------------------------------

my $COLUMN = <<'END';
return Array.from(document.querySelectorAll("#points tbody tr"))
    .filter((row) => row.offsetParent !== null)
    .map((row) => row.cells[arguments[0]].textContent);
END
my $as_written = join ' ', @{ $browser->js( $COLUMN, 1 ) };
is( $as_written, 'hard PCF 3 PCF 7 VSM 3 VSM 7', 'the points, as measured' );

# By error: the table's numbers are rounded, so its order is judged by what
# results.csv has.
my ( $head, @lines ) = split /\n/, slurp("$folder/results.csv");
my %error;
for (@lines) {
    my %row;
    @row{ split /,/, $head } = split /,/, $_, -1;
    $error{ $row{label} } = $row{footprint_rmse};
}
my @by_error = sort { $error{$a} <=> $error{$b} } keys %error;
my $names =
  $browser->js( 'return Array.from(document.querySelectorAll("#points th"),'
      . '(cell) => cell.textContent)' );
my ($place) = grep { $names->[$_] eq 'RMSE' } 0 .. $#$names;
my $button = '#points th:nth-child(' . ( $place + 1 ) . ') button';
$browser->click($button);
is(
    join( ', ', @{ $browser->js( $COLUMN, 1 ) } ),
    join( ', ', @by_error ),
    'sorted by the error'
);
$browser->click($button);
is(
    join( ', ', @{ $browser->js( $COLUMN, 1 ) } ),
    join( ', ', reverse @by_error ),
    'and the other way round'
);
is(
    $browser->js(
        'return document.querySelectorAll("#points th[aria-sort]")' . '.length'
    ),
    1,
    'one column says that it is sorted by'
);
$browser->type( '#technique', 'vsm' );
is( join( ', ', sort @{ $browser->js( $COLUMN, 1 ) } ),
    'VSM 3, VSM 7', 'only the techniques asked for' );
is( $browser->js('return document.getElementById("shown").textContent'),
    '2 points', 'and how many there are' );

# --- a slider ----------------------------------------------------------------

my $CUT = <<'END';
const result = document.querySelector(".card .result");
return getComputedStyle(result).clipPath;
END
like( $browser->js($CUT), qr/50%/, 'half of the truth, half of the result' );
$browser->click('.card input');
$browser->type( '.card input', "\x{E011}" );    # the key Home
like(
    $browser->js($CUT),
    qr/inset\(0(?:px|%)?(?: 0px 0px 0%)?\)/,
    'the slider at its left: all of the result'
);
$browser->type( '.card input', "\x{E014}" x 30 );    # to the right
like( $browser->js($CUT), qr/ 30%/, 'thirty steps to the right: so far' );
is(
    $browser->js(
            'return Array.from(document.images)'
          . '.filter((image) => !image.naturalWidth).length'
    ),
    0,
    'every picture is one'
);
cmp_ok( $browser->js('return document.querySelectorAll("svg").length'),
    '>=', 2, 'diagrams are in the page' );

# --- how it looks ------------------------------------------------------------

# Dark text on light ground, and the other way round.
my $GREYS = <<'END';
const style = getComputedStyle(document.body);
return [style.color, style.backgroundColor].map((colour) =>
    colour.match(/\d+/g).slice(0, 3).reduce((sum, x) => sum + Number(x), 0));
END
for my $look ( [ 1280, 900, 'light' ], [ 390, 844, 'dark' ] ) {
    my ( $width, $height, $scheme ) = @$look;
    $browser->resize( $width, $height );
    $browser->prefer($scheme);
    $browser->open_file("$folder/index.html");
    my ( $text, $ground ) = @{ $browser->js($GREYS) };
    cmp_ok( $scheme eq 'dark' ? $text - $ground : $ground - $text,
        '>', 400, "$scheme: text and ground are far apart" );
    cmp_ok( $browser->js('return document.documentElement.scrollWidth'),
        '<=', $width, "$width wide: nothing sticks out" );
    my $shot = "$folder/page.$width.$scheme.png";
    $browser->js('window.scrollTo(0, 0)');
    $browser->screenshot($shot);
    is( png_size( slurp($shot) ), "${width}x$height", "a picture: $shot" );
}
my @console = $browser->console;
is( "@console", '', 'nothing on the console' );

done_testing;
