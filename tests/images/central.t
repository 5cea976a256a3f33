# --moments central, and --min-variance auto for both kinds of moments. (The
# other tests of step 5 draw with central ones.)
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);
my @tiny  = qw(--size 160x90 --map-size 128);
my @bare  = qw(--bleed-reduction 0);

# Every stage from its own input files, where central moments are not the
# default, and raw ones where they are not.
for my $options (
    [ 3, qw(--moments central) ],
    [ 3, qw(--moments central --format rg16f --slope-term) ],
    [ 4, qw(--moments central --blur gaussian --radius 8 --downsample 2) ],
    [ 4, qw(--moments central --format rg16f --mips --radius 1) ],
  )
{
    my ( $step, @words ) = @$options;
    my $dump = dump_run( $step, @small, @words );
    oracle( $_, $dump ) for qw(files stage);
}
for my $options (
    [qw(--moments raw)],
    [qw(--moments raw --mips --anisotropy 4 --map-size 512)],
    [qw(--moments raw --format rg16f --downsample 2)],
    [qw(--format rg16f --mips --anisotropy 4 --map-size 512)],
    [qw(--msaa 4 --slope-term --blur gaussian)],
  )
{
    my $dump   = dump_run( 5, @small, @bare, @$options );
    my $levels = grep { $_ eq '--mips' } @$options;
    oracle( $_, $dump ) for 'stage', $levels ? () : 'lower';
}

# p is nowhere below the lit share: with auto that is proven, up to the last
# few roundings of the formula.
for my $scene (
    [qw(thin)],
    [qw(fence)],
    [qw(grazing)],
    [qw(avenue --splits 3)],
    [qw(stage)],
    [qw(room)],
    [qw(crowd)],
    [qw(teapot --moments raw)],
    [qw(room --moments raw)],
    [qw(stage --moments raw --format rg16f)],
    [qw(stage --format rg16f --depth projected)],
    [qw(teapot --radius 60)],
  )
{
    oracle( 'lower', dump_run( 5, @tiny, @bare, '--scene', @$scene ) );
}

# Two depths, closer and closer: p is the lit share, within 0.01 down to a gap
# of 1e-4 of the depth range. What is off there are t and the stored depth, by
# some units of 2^-24 each, and what auto adds. A gap of 1e-5 is 168 units.
sub largest_error {
    my @arguments = @_;
    my $run = ask_oracle( 'edge', dump_run( 5, @small, @bare, @arguments ) );
    my ( $worst, $bound ) = $run->{out} =~
      /is the lit share: .* worst (\S+), widest bound (\S+),/
      or return ( 9, 9 );
    return ( $worst, $bound );
}
for my $gap (qw(1e-1 1e-2 1e-3 1e-4 1e-5)) {
    my @scene = ( '--scene', "edge:gap=$gap" );
    my ( $error, $bound ) = largest_error(@scene);
    my $most = $gap == 1e-5 ? $bound : 0.01;
    cmp_ok( $error, '<=', $most, "gap $gap: p off by $error, bound $bound" );
    oracle( 'edge', dump_run( 5, @small, @bare, @scene ) );
}
oracle( 'stage', dump_run( 5, @small, @bare, qw(--scene edge:gap=1e-4) ) );
for my $stored (
    [qw(1e-1 --format rg16f)],
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
# (step5_chebyshev/guard.h) and what the shader's own difference rounds.
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

# What auto leaves of the light in full shadow: at most 1/255 for 32-bit central
# moments at gaps of 1e-2 and more, in the formula's own table.
my $table = command( ( $ENV{VSM_BUILD} // root() . '/build' ) . '/fuzz',
    '--shadows' );
my @left = $table->{out} =~ /^fp32\s+central\s+\d+\s+1e-0[12]\s+(\S+)/mg;
is( scalar( grep { $_ <= 1 / 255 } @left ), 4, "in full shadow: @left" );

done_testing;
