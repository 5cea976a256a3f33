# `make bench`: the exponents it fits and the claims it judges, of programs
# that print times made up so that the answer is known.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;
use lib root() . '/tests/report';
use Bench  qw(points);
use Growth qw(exponent);
use Startup qw(starts_within waits);

# --- the fit -----------------------------------------------------------------

sub near {
    my ( $found, $right, $name ) = @_;
    ok( defined $found && abs( $found - $right ) < 1e-12, $name )
      or diag( $found // 'nothing' );
    return;
}

near( exponent( map { [ $_, 3 * $_**1.7 ] } 2, 3, 40 ),
    1.7, 'a power is found' );
near( exponent( map { [ $_, 7 ] } 1, 2, 9 ), 0, 'what does not grow has 0' );
near( exponent( [ 4, 1 ], [ 16, 2 ] ), 0.5, 'two points are joined' );

# Logarithms 0, 1, 2, of times 0, 0, 3: the line of least squares has slope
# (-1 * 0 + 1 * 3) / 2.
near( exponent( [ 1, 1 ], [ exp 1, 1 ], [ exp 2, exp 3 ] ),
    1.5, 'the squares of the distances are the least' );
is( exponent( [ 2, 5 ], [ 2, 6 ] ), undef, 'no line through one value' );
is( exponent(),                     undef, 'nor through none' );

# --- what it prints ----------------------------------------------------------

my $folder = tempdir( CLEANUP => 1 );

# All five programs, and their milliseconds by pass: Perl of %option, what
# follows each option.
sub programs {
    my ( $name, $times ) = @_;
    for ( 1 .. 5 ) {
        my $path = "$folder/$name/" . program_name($_);
        spew( $path, "#!$^X\nmy \$step = $_;\n" . <<'END' . $times . <<'END2' );
my %option = "@ARGV " =~ /(--[a-z-]+) ((?!--)\S*)/g;
$option{'--kernel'} //= 7;
$option{'--radius'} //= 3;
my ($map) = $option{'--map-size'} // 512;
my ( $wide, $high ) = split /x/, $option{'--size'};
my @vary = 1;
my %ms = ( shading => 1e-3 * $wide * $high );
END
print "pass,median_ms,clock,samples_ms\n";
$ms{total} += $_ for values %ms;
for my $pass ( keys %ms ) {
    print "$pass,,made up,@{[ map { $_ * $ms{$pass} } @vary ]}\n";
}
END2
        chmod 0755, $path;
    }
    return "$folder/$name";
}

sub bench {
    my ($programs) = @_;
    local $ENV{BENCH_OUT}     = "$folder/out";
    local $ENV{BENCH_SECONDS} = 0;               # one round
    local $ENV{VSM_BUILD}     = $programs;
    local $VSM::SECONDS       = 600;
    return command( $^X, root() . '/tests/report/bench.pl' );
}

# PCF's shading takes n^2; a map texels, but the table's by fragments six times
# as many; the crowd's map costs a fifth of the picture.
my $right = <<'END';
$ms{shading} *= $option{'--kernel'}**2 if $step == 2;
if ( $option{'--shadows'} ne 'off' ) {
    $ms{moments} = 2e-4 * $map**2;
    $ms{blur} = 2e-4 * $map**2 * ( $option{'--splits'} // 1 );
    $ms{blur} *= 6 if $option{'--sat-by'} eq 'fragments';
    @ms{qw(moments blur)} = ( 0, 0 ) unless "@ARGV" =~ /--redraw/;
}
END
my $run = bench( programs( 'right', $right ) );
is( $run->{status}, 0, 'all is measured, and the claims hold' )
  or diag( $run->{out}, $run->{err} );
my @lines = split /\n/, $run->{out};

sub line_like {
    my ( $pattern, $name ) = @_;
    ok( scalar( grep { /$pattern/ } @lines ), $name ) or diag( $run->{out} );
    return;
}
line_like(
    qr/^PCF: shading +2\.00 +2\.00 +518\.40 /,
    'PCF grows with the square of its width'
);
line_like( qr/^VSM, box: blur\+shading +0\.00 +0\.00 +110.03 /,
    'VSM does not grow' );
line_like(
    qr/^VSM: map +2\.00 +2\.00 +13\.11 +52\.43 /,
    'a map grows with the square of its side'
);
line_like( qr/^unshadowed: shading +1\.00 +1\.00 +57\.60 /,
    'a picture with its pixels' );
line_like( qr/^VSM: blur +1\.00 +1\.00 +52\.43 /, 'splits with their number' );
line_like( qr/^holds PCF over width, last exponent: 2\.00, at least 1\.8/,
    'that is claimed' );
# (The programs are real ones; how busy the machine is they do not make up.)
line_like(
    qr/^(?:holds|unclear) from the start to the file: \d+\.\d+ seconds, at/,
    'a start takes no time'
);
line_like( qr/^holds table .*: 0\.17, at most 0\.2/, 'the table is, too' );
line_like( qr/^reached crowd .* VSM over --shadows off: 1\.20, at most 1\.8/,
    'a frame' );
line_like(
    qr/^reached crowd .* unchanged scene, .*: 1\.00, at most 1\.15/,
    'a frame whose map is there already'
);
unlike( $run->{out}, qr/FAILS|missed|MISSING/, 'nothing fails or is missing' );
my @rows = split /\n/, slurp("$folder/out/results.csv");
is(
    $rows[0],
    'sweep,run,value,pass,median_ms,q1_ms,q3_ms,frames,clock',
    'the results have a head'
);
ok( @rows > 2 * points(), 'and rows for each point' );

# --- what goes wrong ---------------------------------------------------------

$run = bench( programs( 'slow', $right . <<'END' ) );
$ms{shading} *= 2 if $option{'--scene'} =~ /crowd/ && $ms{moments};
$ms{blur} *= $option{'--radius'};
select undef, undef, undef, 0.7 if !$option{'--bench'} && "@ARGV" =~ /png$/;
END
is( $run->{status}, 1, 'a claim that fails: the exit status tells' );
like( $run->{out}, qr/^FAILS $_/m, "a claim that fails: $_" )
  for 'VSM, box over width, last exponent: 0\.99',
  'blur of 1024\^2, boxes: radius 64 in compute over 2 in fragments: 32\.00';
like( $run->{out}, qr/^holds PCF/m, 'another one holds' );
like(
    $run->{out},
    qr/^(?:FAILS|unclear) from the start to the file: (?:0\.[7-9]|[1-9])/m,
    'nor does a slow start hold'
);
is( starts_within( 0.6, 0.7, 1.1 ), 0, 'it fails' );
is( starts_within( 0.6, 0.7, 1.3 ), undef, 'but not where it had to wait' );
is( starts_within( 0.6, 0.6, 9 ), 1, 'what is quick there holds' );
cmp_ok( waits(), '>', 0.9, 'to compute takes as long as it takes' );

# Every other frame takes four times as long, as where others have the cores.
$run = bench( programs( 'busy', $right . <<'END' ) );
$ms{shading} *= 2 if $option{'--scene'} =~ /crowd/ && $ms{moments};
$ms{blur} *= $option{'--radius'}**0.4;
@vary = ( 1, 1, 4, 4 );
END
is( $run->{status}, 0, 'on a busy machine: the exit status does not tell' )
  or diag( $run->{out}, $run->{err} );
like( $run->{out}, qr/^unclear $_/m, "on a busy machine: $_" )
  for 'VSM, box over width, last exponent: 0\.3\d',
  'crowd .* VSM over --shadows off: 2\.2\d';
like( $run->{out}, qr/^holds PCF/m, 'what is beyond doubt holds' );
unlike( $run->{out}, qr/^FAILS/m, 'nothing fails' );

$run = bench( programs( 'late', $right . <<'END' ) );
$ms{shading} *= 2 if $option{'--scene'} =~ /crowd/ && $ms{moments};
END
is( $run->{status}, 0, 'an aim that is missed: the exit status does not tell' )
  or diag( $run->{out}, $run->{err} );
like( $run->{out},
    qr/^missed crowd .* VSM over --shadows off: 2\.20, at most 1\.8$/m,
    'but a line does' );
like( $run->{out}, qr/^reached crowd .* unchanged/m, 'another one is reached' );

$run = bench( programs( 'small', $right . <<'END' ) );
die "no memory\n" if $map == 8192;
END
is( $run->{status}, 3, 'what cannot be measured: the exit status tells' );
like(
    $run->{out},
    qr/^MISSING map VSM 8192: exit status \d+: no memory$/m,
    'what is missing, and why'
);
like(
    $run->{out},
    qr/^VSM: map +2\.00 +2\.00 .* -$/m,
    'the exponent is that of the rest'
);

{
    local $ENV{BENCH_SECONDS} = 'long';
    my $refused = command( $^X, root() . '/tests/report/bench.pl' );
    is(
        "$refused->{status} $refused->{err}",
        "2 bench: BENCH_SECONDS=long: a number of seconds is needed\n",
        'a time that is no number is refused'
    );
}

# --- `make saved` ------------------------------------------------------------

sub saved {
    my ( $programs, @scenes ) = @_;
    local $ENV{BENCH_OUT} = "$folder/out";
    local $ENV{VSM_BUILD} = $programs;
    return command( $^X, root() . '/tests/report/saved.pl', @scenes );
}

$run = saved( programs( 'planned', <<'END' ), 'room:turn=-100', 'empty' );
$ms{depth} = "@ARGV" =~ /--keep-all/ ? 960 : 0.5;
$ms{shading} += 10 if "@ARGV" =~ /--shadows off/;
END
is( $run->{status}, 0, 'what is saved: the claims hold' )
  or diag( $run->{out}, $run->{err} );
like(
    $run->{out},
    qr/^room:turn=-100 +3 +230\.90 +1190\.40 +5\.16 +240\.90 +0\.96$/m,
    'a row of the table'
);
like(
    $run->{out},
    qr/^holds room:turn=-100, step 5: .* 5\.16, at least 2$/m,
    'before a wall'
);
like(
    $run->{out},
    qr/^holds empty, step 1: .* 0\.96, at most 1\.05$/m,
    'where nothing casts'
);
is( scalar( () = slurp("$folder/out/saved.csv") =~ /\n/g ),
    31, 'the results have a head and a row for each' );

$run = saved( programs( 'kept', '$ms{depth} = "@ARGV" =~ m{off} ? 0 : 90;' ),
    'room:turn=-100', 'empty' );
is( $run->{status}, 1, 'nothing saved: the exit status tells' );
like( $run->{out}, qr/^FAILS $_/m, "nothing saved: $_" )
  for 'room:turn=-100, step 1', 'empty, step 5';

# One of three runs without shadows is a tenth faster.
$run = saved( programs( 'luck', <<'END' ), 'empty' );
if ( "@ARGV" =~ /--shadows off/ ) {
    open my $runs, '>>', "$0.runs";
    syswrite $runs, 'x';
    $ms{shading} *= 0.9 if ( -s "$0.runs" ) % 3 == 0;
}
END
is( $run->{status}, 0, 'where rounds disagree: the exit status does not tell' );
like( $run->{out}, qr/^unclear empty, step 5: .* 1\.11, at most 1\.05$/m,
    'it is unclear' );

done_testing;
