# --moments central, and --min-variance auto for both kinds of moments.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

of_steps( 3, 4, 5 );

my @small = qw(--size 320x180 --map-size 256);
my @tiny  = qw(--size 160x90 --map-size 128);
my @least = qw(--size 96x54 --map-size 96);
my @bare  = qw(--bleed-reduction 0);

# Every stage from its own input files.
for my $options (
    [ 3, qw(--moments central) ],
    [ 3, qw(--moments central --format rg16f --slope-term) ],
    [ 4, qw(--moments central --blur gaussian --radius 8 --downsample 2) ],
    [ 4, qw(--moments central --format rg16f --mips --radius 1) ],
  )
{
    my ( $step, @words ) = @$options;
    next if !is_chosen($step);
    my $dump = dump_run( $step, @small, @words );
    oracle( $_, $dump ) for qw(files stage);
}
if ( !is_chosen(5) ) {
    done_testing;
    exit;
}
for my $options (
    [qw(--moments raw)],
    [qw(--moments raw --mips --anisotropy 4 --map-size 512)],
    [qw(--moments raw --format rg16f --downsample 2)],
    [qw(--moments central)],
    [
        qw(--moments central --format rg16f --mips --anisotropy 4),
        qw(--map-size 512)
    ],
    [qw(--moments central --msaa 4 --slope-term --blur gaussian)],
    [qw(--moments central --downsample 2 --radius 8)],
    [qw(--moments central --map-size 300x180)],
  )
{
    my $dump   = dump_run( 5, @small, @bare, @$options );
    my $levels = grep { $_ eq '--mips' } @$options;
    oracle( $_, $dump ) for 'stage', $levels ? () : 'lower';
}

# p is nowhere below the lit share, on any scene and of either moments: with auto
# that is proven, up to the last few roundings of the formula. Left out is what
# the program refuses, and where no surface that faces the light is in the map.
my %nothing_to_see = map { $_ => 1 } qw(broken unlit offstage);
my ( $list, %scenes ) = run( 1, '--list-scenes' )->{out};
$scenes{$1} = 1 while $list =~ /^(\w+)  \S/mg;
delete @scenes{ keys %nothing_to_see };
ok( keys %scenes >= 20, keys(%scenes) . ' scenes' );
for my $scene ( sort keys %scenes ) {
    oracle( 'lower',
        dump_run( 5, @least, @bare, '--scene', $scene, '--moments', $_ ) )
      for qw(raw central);
}
for my $options (
    [qw(--scene avenue --splits 3 --moments central)],
    [qw(--scene stage --moments raw --format rg16f)],
    [qw(--scene stage --moments central --format rg16f --depth projected)],
    [qw(--scene teapot --radius 40 --moments central)],
  )
{
    oracle( 'lower', dump_run( 5, @tiny, @bare, @$options ) );
}

# Two depths, closer and closer: p is the lit share, within 0.01 down to a gap
# of 1e-4 of the depth range. What is off there are t and the stored depth, by
# some units of 2^-24 each, and what auto adds. A gap of 1e-5 is 168 units.
for my $gap (qw(1e-1 1e-2 1e-3 1e-4 1e-5)) {
    my $dump = dump_run( 5, @small, @bare, '--moments', 'central', '--scene',
        "edge:gap=$gap" );
    oracle( 'edge', $dump );
    my ( $error, $bound ) = ask_oracle( 'edge', $dump )->{out} =~
      /is the lit share: .* worst (\S+), widest bound (\S+),/;
    cmp_ok( $error, '<=', $gap == 1e-5 ? $bound : 0.01,
        "gap $gap: p off by $error, bound $bound" );
}
oracle( 'stage',
    dump_run( 5, @small, @bare, qw(--moments central --scene edge:gap=1e-4) ) );
for my $stored (
    [qw(1e-1 --moments central --format rg16f)],
    [qw(1e-2 --moments raw)],
    [qw(0.8 --moments raw --format rg16f)]
  )
{
    my ( $gap, @options ) = @$stored;
    oracle( 'edge',
        dump_run( 5, @small, @bare, '--scene', "edge:gap=$gap", @options ) );
}

# Three depths: how much light bleeds does not depend on what is stored.
for my $moments (qw(raw central)) {
    oracle( 'bleed',
        dump_run( 5, @small, @bare, qw(--scene bleed:r=4 --moments), $moments ),
        'r=4' );
}

# Both say the same about a teapot: means within 16 roundings of the blur, and
# variances within the bound of raw ones, K M2 with K = 45 u of a box of 7 x 7
# (proof.md of step 5's guard) and what the shader's own difference rounds.
my ( $raw, $central ) =
  map { dump_run( 4, @small, '--moments', $_ ) . '/blurred.0.exr' }
  qw(raw central);
my $difference = "$raw.variance.exr";
system( 'oiiotool', $raw, '--ch', '1', $raw, '--ch', '0', '--dup', '--mul',
    '--sub', '-d', 'float', '-o', $difference );
system( 'oiiotool', $central, '--ch', '1', '-d', 'float', '-o', "$central.1.exr" );
oracle( 'compare', $difference, "$central.1.exr", 'max=2.9e-6' );
same_mean( $raw, $central );

sub same_mean {
    my @copies;
    for my $file (@_) {
        push @copies, "$file.0.exr";
        system( 'oiiotool', $file, '--ch', '0', '-d', 'float', '-o',
            $copies[-1] );
    }
    oracle( 'compare', @copies, 'max=1e-6' );
    return;
}

# What auto leaves of the light in full shadow: at most 1/255 at gaps of 1e-2
# and more, of central moments. (So near to its caster a shadow shows only a few
# texels of itself.)
for my $options (
    [ @small, qw(--scene edge:gap=1e-1) ],
    [ qw(--scene edge:gap=1e-2 --size 640x360 --map-size 1024 --radius 1) ],
  )
{
    my $run = ask_oracle( 'edge',
        dump_run( 5, @$options, @bare, qw(--moments central) ) );
    my ( $left, $pixels ) =
      $run->{out} =~ /lit share: .*; (\S+) left in full shadow \((\d+)\)/;
    cmp_ok( $pixels, '>', 100, "in full shadow: $pixels pixels" );
    cmp_ok( $left, '<=', 1 / 255, "@$options: $left left of the light" );
}

# The same of the formulas alone, step 5's own numbers among them, as the table
# in the guard's README has it.
my $fuzz = ( $ENV{VSM_BUILD} // root() . '/build' ) . '/fuzz';
my %left;    # by format, moments, gap
for ( split /\n/, command( $fuzz, '--shadows' )->{out} ) {
    my ( $format, $moments, $taps, $gap, $p ) = split;
    $left{"$format $moments"}{$gap} = $p if $taps eq '7';
}
cmp_ok( $left{'fp32 central'}{$_}, '<=', 1 / 255, "gap $_: auto leaves" )
  for qw(1e-01 1e-02);
my $words = slurp( root() . '/step5_chebyshev/techniques/guard/README.md' );
my @rows  = $words =~ /^ *\| (1e-\d(?: \| [\d.e-]+){4}) \|$/mg;
is( scalar @rows, 6, 'six gaps in the table' );
for (@rows) {
    my ( $gap, @table ) = split / \| /;
    my @found = map { $left{$_}{ $gap =~ s/-/-0/r } } 'fp32 central',
      'fp32 raw', 'fp16 central', 'fp16-truncated raw';
    ok( !( grep { abs( $table[$_] / $found[$_] - 1 ) > 0.05 } 0 .. 3 ),
        "gap $gap: @table in the table, @found found" );
}

done_testing;
