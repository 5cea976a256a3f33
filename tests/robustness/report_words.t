# The report's front and verdicts, from numbers made up so that the answer is
# known.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;
use lib root() . '/tests/report';
use Columns qw(@COLUMNS csv);
use Judge   qw(busy claims mark_front outcome ratio);
use Plot    qw(stair work_precision);
use Sweep   qw(mode sweep);
use Html    qw(number);
use Verdict qw(verdict compared in_short);

# A point: its label, milliseconds round by round, error.
sub point {
    my ( $label, $times, $rmse, %more ) = @_;
    my ($width) = $label =~ / (\d+)$/;
    my @sorted = sort { $a <=> $b } @$times;
    return {
        scene          => 'teapot',
        label          => $label,
        width          => $width // 1,
        medians        => { total   => $times, shading => $times },
        fastest        => { shading => $times },
        total_ms       => $sorted[ @sorted / 2 ],
        shading_q3     => $sorted[-1],
        total_q1       => $sorted[0],
        total_q3       => $sorted[-1],
        footprint_rmse => $rmse,
        %more
    };
}

# PCF takes the width's square.
my @widths = ( 3, 7, 15, 31 );
my @pcf    = map { point( "PCF $_", [ $_**2 ], 0.01 ) } @widths;

# --- where one overtakes the other -------------------------------------------

# VSM takes the same at every width.
sub vsm {
    my ( $time, $rmse, %more ) = @_;
    return map { point( "VSM $_", [$time], $rmse, %more ) } @widths;
}
my $says = sub { join ' ', verdict( 'teapot', @_ ) };
like(
    $says->( @pcf, vsm( 24.99, 0.01 ) ),
qr/^PCF is faster below width 5, VSM from there on; at 15 VSM is 9\.0 times as/,
    'they cross at 5: width^2 = 25'
);
like(
    $says->( @pcf, vsm( 26, 0.01 ) ),
    qr/^PCF is faster below width 7,/,
    'a little later: the next odd width'
);
like(
    $says->( @pcf, vsm( 1, 0.01 ) ),
    qr/^VSM is faster than PCF at every width measured, from 3 on; at 15 VSM/,
    'no crossing: VSM from the first on'
);
like(
    $says->( @pcf, vsm( 1922, 0.01 ) ),
    qr/^PCF is faster than VSM at every width measured; at 15 PCF is 8\.5/,
    'no crossing: PCF up to the last'
);
like(
    $says->( @pcf, vsm( 450, 0.01 ) ),
    qr/below width 23, .*; at 15 PCF is 2\.0 times as fast, at 31 VSM is 2\.1 /,
    'they cross beyond 15'
);
my @odd = vsm( 50, 0.01 );
$odd[0]{medians}{total} = [1];
like(
    $says->( @pcf, @odd ),
    qr/^PCF is faster below width 9 \(but for 3\), VSM from there on;/,
    'they cross three times: what is true of each width'
);
@odd = vsm( 1922, 0.01 );
$_->{medians}{total} = [1] for @odd[ 0, 1 ];
like(
    $says->( @pcf, @odd ),
    qr/^VSM does not overtake PCF for good: it is faster only at 3 and 7;/,
    'it is not faster at the widest'
);
is(
    verdict( 'teapot', @pcf ),
    'PCF and VSM were not both measured here.',
    'half of what it takes: no verdict'
);

# A slow round hits both: the ratio is that of the same round.
is(
    ratio(
        'total',
        point( 'PCF 7', [ 10, 100, 12 ], 1 ),
        point( 'VSM 7', [ 5,  50,  3 ],  1 )
    ),
    2,
    'ratios are made round by round'
);

# Two rounds of three frames; the first pass fills the map, whatever its name.
my %timed;
Measure::summarise(
    \%timed,
    map { { clock => 'a clock', passes => { depth => $_ } } } [ 9, 1, 2 ],
    [ 6, 4, 5 ]
);
is_deeply(
    \%timed,
    {
        clock   => 'a clock',
        rounds  => 2,
        frames  => 0,
        medians => { map => [ 2, 5 ] },
        fastest => { map => [ 1, 4 ] },
        map_ms  => 4.5,
        map_q1  => 2.5,
        map_q3  => 5.75,
    },
    'times: of all frames, and round by round'
);

# Quartiles a factor of 1.2, 1.3 and 1.6 apart, and then 1.5 too.
my @quartiles = map { { total_q1 => 10, total_q3 => $_ } } 12, 13, 16;
is( busy(@quartiles), '', 'half of the times vary by 1.3: not busy' );
like(
    busy( @quartiles, { total_q1 => 10, total_q3 => 15 } ),
    qr/^The machine was busy: .* factor of 1\.4 /,
    'half of them by 1.4: busy'
);

# --- how wrong ---------------------------------------------------------------

like(
    $says->( @pcf, vsm( 25, 0.018, chain_chebyshev_rmse => 0.015 ) ),
qr/At width 7 .* 1\.8 .* PCF \(RMSE 0\.0180 .* 0\.0100; it comes from light bleeding\)/,
    'what the error is, and its largest source'
);
my @sources = (
    chain_footprint_rmse => 9,
    chain_pcf_rmse       => 0.02,
    chain_chebyshev_rmse => 0.01,
    chain_floor_rmse     => 0.0099
);
like(
    $says->( @pcf, vsm( 25, 0.018, @sources ) ),
    qr/it comes from the map's texels and light bleeding\)/,
    'its sources; not the filter, which was asked for, and no small one'
);
like(
    $says->(
        @pcf,
        vsm( 25, 0.018 ),
        point( 'VSM reduced 7',  [1], 0.015 ),
        point( 'VSM reduced 31', [1], 0.02 )
    ),
    qr/takes VSM's RMSE from 0.0180 to 0.0150 at 7 and from 0.0180 to 0.02/,
    'what the reduction does'
);
like(
    $says->( @pcf, vsm( 25, 0.0101 ) ),
    qr/as near to its footprint as PCF/,
    'no difference to speak of'
);
like(
    $says->( @pcf, vsm( 25, 0.005 ) ),
    qr/nearer to its footprint than PCF/,
    'VSM can be nearer'
);

my @hard = point( 'hard', [5], 0.015 );
unlike( $says->( @pcf, @hard, vsm( 25, 0.018 ) ),
    qr/Do not/, 'worse than hard, but less than twice PCF: no warning' );
unlike( $says->( @pcf, point( 'hard', [5], 0.03 ), vsm( 25, 0.025 ) ),
    qr/Do not/, 'more than twice PCF, but nearer than hard: no warning' );
like(
    $says->( @pcf, @hard, vsm( 25, 0.03 ) ),
    qr/Do not use VSM on teapot: [^.]*\.$/,
    'worse than hard, and than twice PCF'
);
unlike(
    $says->(
        @pcf,            @hard,
        vsm( 25, 0.03 ), point( 'VSM reduced 31', [25], 0.015 )
    ),
    qr/Do not/,
    'at the widest one setting works: no warning'
);
like(
    $says->(
        @pcf, @hard,
        vsm( 25, 0.03 ),
        point( 'VSM reduced 7', [25], 0.015 )
    ),
    qr/Do not use VSM on teapot from width 15 on: [^.]*\.$/,
    'one setting works up to 7: a warning from 15 on'
);

# --- all scenes together -----------------------------------------------------

my $short = sub {
    my %scenes = @_;
    return join ' ',
      in_short(
        map { [ $_ => compared( @{ $scenes{$_} } ) ] }
        sort keys %scenes
      );
};
is_deeply(
    compared( @pcf, @hard, vsm( 26, 0.03 ) ),
    {
        from    => 7,
        widest  => 31,
        faster  => { map { $_ => $_**2 / 26 } @widths },
        wronger => { map { $_ => 3 } @widths },
        useless => '',
    },
    'a scene in numbers'
);
is( compared(@pcf), undef, 'without VSM there is nothing to compare' );
is(
    $short->(
        one => [ @pcf, @hard, vsm( 26, 0.03 ) ],
        two => [
            @pcf, @hard, vsm( 1, 0.03 ), point( 'VSM reduced 15', [1], 0.015 )
        ],
        three => [ @pcf, vsm( 450, 0.01 ) ],
        never => [ @pcf, vsm( 961, 0.01 ) ],
    ),
    'VSM overtakes PCF at width 3 to 23. It does not on never, up to 31. '
      . 'It is 0.2 to 225 times as fast at 15 and 1.0 to 961 times as fast at '
      . '31. Do not use VSM on one and two (from width 31 on).',
    'scenes in short'
);
is(
    join( ' ',
        map { number(@$_) } [0.02346],
        [2.346], [234.6], [2345], [0.00012], [0], [''], [ 2.346, 2 ] ),
    '0.0235 2.35 235 2345 1.2e-04 0  2.3',
    'numbers: their digits'
);

# --- the front ---------------------------------------------------------------

my @points = (
    point( 'a', [ 9,  10, 11 ], 0.3 ),
    point( 'b', [ 19, 20, 21 ], 0.2 ),
    point( 'c', [ 20, 21, 22 ], 0.2 ),    # b's time, for all that is known
    point( 'd', [ 30, 31, 32 ], 0.2 ),
    point( 'e', [ 30, 31, 32 ], 0.1 ),
    point( 'f', [ 1,  1,  1 ],  0.4, scene => 'edge' ),
);
mark_front(@points);
is(
    join( ' ', map { "$_->{label}$_->{front}" } @points ),
    'a1 b1 c1 d0 e1 f1',
    'the front: clearly faster, and no more wrong'
);

# The stair of the diagram is the strict one, by medians.
is( join( ' ', map { $_->{label} } stair( 'footprint', @points[ 0 .. 4 ] ) ),
    'a b e', 'the stair: each corner is slower, and less wrong' );

# Beside an area light, each point is named.
my ($drawn) = work_precision(
    tempdir( CLEANUP => 1 ),
    'teapot',
    'area',
    point( 'hard',        [5], 0.02, family => 'hard', area_rmse => 0.05 ),
    point( 'soft hybrid', [9], 0.02, family => 'soft', area_rmse => 0.01 )
);
like( $drawn, qr/against the area light/,
    'soft techniques have a diagram of their own' );
like( $drawn, qr/>\s*soft hybrid\s*</, 'where each is named' );

# --- claims ------------------------------------------------------------------

my @claims = claims(
    point( 'VSM 3',  [1], 0.1, scene => 'edge',  pcf_rmse => 2e-4 ),
    point( 'VSM 7',  [1], 0.1, scene => 'edge',  pcf_rmse => 2e-5 ),
    point( 'VSM 3',  [1], 0.1, scene => 'bleed', pcf_max  => 0.436 ),
    point( 'VSM 7',  [1], 0.1, scene => 'bleed', pcf_max  => 0.434 ),
    point( 'VSM 15', [1], 0.1, scene => 'bleed', pcf_max  => 0.4533 ),
    point( 'VSM 31', [1], 0.1, scene => 'bleed', pcf_max  => 0.4534 ),
    point( 'VSM 15', [1], 0.1, scene => 'edge',  missing  => 'it crashed' ),
);
is(
    join( ' ', map { outcome($_) } @claims ),
    'holds holds FAILS holds holds FAILS holds FAILS',
    'claims: finite; edge 1e-4, not of what is missing; bleed 4/9, 2 %'
);

is( claims( point( 'VSM 3', [1], 0.1, missing => 'it crashed' ) ),
    0, 'of what is missing nothing is claimed' );

# What is claimed of shading with a narrow and a wide filter, from the fastest
# frames of some rounds.
sub growth {
    my ( $name, $narrow, $wide, @more ) = @_;
    my @claims = claims(
        point( 'hard',     [ 0.6, 0.5 ], 0.1, scene => 'thin' ),
        point( "$name 7",  $narrow,      0.1, scene => 'thin', @more ),
        point( "$name 31", $wide,        0.1, scene => 'thin' )
    );
    return outcome( grep { $_->{text} =~ /shading/ } @claims );
}
is( growth( 'PCF', [1], [4.55] ),
    'holds', 'PCF 31 adds 8 times as much to hard shadows as PCF 7' );
is( growth( 'PCF', [1], [4.45] ), 'FAILS', 'or the claim fails' );
is( growth( 'VSM', [1], [1.19] ), 'holds', 'VSM 31 shades no longer' );
is( growth( 'VSM', [1], [1.21] ), 'FAILS', 'or the claim fails' );
is( growth( 'VSM', [ 9, 1 ], [ 1, 5 ] ),
    'holds', 'a slow round does not decide: the fastest does' );
is( growth( 'VSM', [ 1, 1.1 ], [ 1.5, 1.3 ] ),
    'unclear', 'where rounds disagree about it, nothing is claimed' );
is( growth( 'VSM', [ 1, 1.1 ], [ 1.5, 1.4 ] ),
    'FAILS', 'where all agree that it fails, it does' );

is(
    growth( 'VSM', [ 1, 1 ], [ 1.3, 1.3 ], shading_q3 => 1.4 ),
    'unclear', 'where frames differ by more than that, nothing is claimed'
);
is( growth( 'PCF', [0.4], [4] ), 'unclear', 'nor where PCF adds nothing' );

# --- the sweep ---------------------------------------------------------------

my ( $all, $left_out ) = sweep( mode('full') );
cmp_ok( scalar @$all, '>=', 150, 'at least 150 points' );
my %seen;
$seen{"$_->{scene} $_->{label}"}++ for @$all;
is( join( ', ', grep { $seen{$_} > 1 } sort keys %seen ), '',
    'no point twice' );
is( ( grep { $_->{reason} eq '' } @$left_out ),
    0, 'a reason for all that is left out' );
my %scenes = map { $_->{scene} => 1 } @$all;

for my $scene ( sort keys %scenes ) {
    my @lacking =
      grep { !$seen{"$scene $_"} } map { ( "PCF $_", "VSM $_" ) } @widths;
    is( "@lacking", '', "$scene: PCF and VSM at the widths of a verdict" );
}

# Each technique of the first page is measured, or it is said why not.
my %named = map { $_ => 1 } map { @{ $_->{options} } } @$all;
$named{$_} = 1 for map { $_->{what} =~ /(--[a-z-]+)/g } @$left_out;
my ($page) =
  slurp( root() . '/README.md' ) =~ /^(\| technique \|.*?)^(?!\|)/ms;
my @flags = $page =~ /`(--[a-z-]+)/g;
cmp_ok( scalar @flags, '>=', 30, 'techniques of the first page' );
is( join( ' ', grep { !$named{$_} } @flags ),
    '', 'each is measured, or left out for a reason' );

# Each technique on each scene, with its narrowest filter: its options are ones
# that the program takes together. To list the scenes is the last thing it does
# before it draws.
my ( %asked, %refused );
for my $point ( sort { $a->{width} <=> $b->{width} } @$all ) {
    my ( $technique, $scene ) = @$point{qw(technique scene)};
    next if $asked{$technique}{$scene}++;
    my $run = run( $point->{step}, @{ $point->{options} }, '--list-scenes' );
    push @{ $refused{$technique} }, "$scene: $run->{err}" if $run->{status};
}
is( "@{ $refused{$_} // [] }", '', "$_: the program takes its options" )
  for sort keys %asked;

my $csv = csv( { scene => 'a,b', label => 'say "x"', options => [qw(--x y)] } );
like( $csv, qr/\n"a,b",,"say ""x""",,,,--x y,/, 'csv: quoted where needed' );

# The README's table of columns, in groups as a shell writes them.
my $readme = slurp( root() . '/tests/report/README.md' );
is(
    join( ' ', sort map { glob } $readme =~ /^\| `([a-z0-9_{},]+)` \|/mg ),
    join( ' ', sort map { $_->[0] } @COLUMNS ),
    'the README documents each column'
);

done_testing;
