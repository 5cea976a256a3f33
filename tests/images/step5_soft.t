# Step 5's soft penumbra: --soft and --hybrid.
use strict;
use warnings;
use Test::More;
use List::Util qw(min);
use VSM;

my @small = qw(--soft --size 160x90 --map-size 256);
my @bare  = qw(--bleed-reduction 0);    # --hybrid has none

# Every stage from its own input files: all lights and layers, what else the
# filter may be made of, and a light that is larger than the search.
for my $options (
    [@bare],
    ['--hybrid'],
    [ @bare, qw(--scene stage --light-size 0.3 --moments central) ],
    [qw(--hybrid --scene stage --light-size 0.3 --deferred)],
    [qw(--scene room --light-size 0.2 --map-size 128)],
    [qw(--hybrid --scene room --light-size 0.2 --map-size 128)],
    [ @bare, qw(--scene avenue --splits 3 --moments central) ],
    [qw(--hybrid --scene avenue --splits 2)],
    [qw(--light-size 1 --penumbra-scale 2 --downsample 2)],
    [ @bare, qw(--blur box --radius 2 --min-variance 1e-5) ],
    [ @bare, qw(--scene stage --depth projected --map-size 300x180) ],
  )
{
    note("@$options");
    oracle( 'stage', dump_run( 5, @small, @$options ) );
}

# The border is as wide as the light wants, up to a quarter of the map.
for my $options (
    [@bare],
    [qw(--scene stage --light-size 1 --map-size 300x180)],
    [qw(--scene room --light-size 0.2 --map-size 128)],
    [qw(--hybrid --scene avenue --splits 2)],
    [qw(--light-size 1 --penumbra-scale 2 --downsample 2)],
  )
{
    note("@$options");
    oracle( 'matrix', dump_run( 5, @small, @$options ) );
}

# Away from every silhouette a ray says the same; no light bleeds there.
oracle( 'rays', dump_run( 5, @small, qw(--scene stage --hybrid) ) );

# A light almost along the floor leaves it lit, whatever its size: a plane does
# not shadow itself. The bound by no more than all_scenes.t derives.
my @grazing = qw(--soft --scene grazing --light-size 0.3 --size 160x90);
for my $options ( [@bare], ['--hybrid'] ) {
    my @dumps = map { dump_run( 5, @grazing, @$options, @$_ ) } [],
      [qw(--shadows off)];
    oracle( 'compare', ( map { "$_/visibility.exr" } @dumps ), 'max=1e-3' );
}

# A penumbra is as wide as the light makes it, over a range of more than 10 to
# 1; the same under --hybrid.
my @law    = qw(--soft --size 320x180 --map-size 1024);
my %lights = (
    '--light-size 0.02'             => [ 0.08, 0.8, 0.25 ],
    '--light-size 0.4 --light spot' => [ 0.1,  0.6 ],
);
for my $light ( sort keys %lights ) {
    for my $gap ( @{ $lights{$light} } ) {
        my @words = ( @law, split( / /, $light ), '--scene', "edge:gap=$gap" );
        note("@words");
        oracle( 'penumbra', dump_run( 5, @words, @bare ) );
        oracle( 'penumbra', dump_run( 5, @words, '--hybrid' ) )
          if $gap == $lights{$light}[1];    # the widest
    }
}
oracle( 'penumbra',
    dump_run( 5, @law, @bare, qw(--scene edge:gap=0.6 --penumbra-scale 0.4) ) );

# In full shadow below two occluders the bound lets a quarter of the light
# bleed; a comparison lets none.
oracle( 'umbra', dump_run( 5, @small, qw(--scene bleed --hybrid) ) );

# One row of the oracle's table of errors.
sub area_error {
    my ( $size, @options ) = @_;
    my $dump  = dump_run( 5, @options );
    my $table = ask_oracle( 'errors', $dump, "light-size=$size", 'rays=64' );
    my @row   = $table->{out} =~ /^area,\d{4,},\d+,0,([^,]+),[^,]+,([^,]+),/m
      or diag( $table->{out} );
    return @row;
}

# The map ends well outside every penumbra: nowhere does an edge of it cut one.
# A straight edge cuts from 32 points what it cuts from the disc, but for at
# most 0.083; what each point's own bell adds to the disc's profile is under
# 0.02. A penumbra that is cut off in its outer half would be wrong by 0.5.
my ( undef, $worst ) =
  area_error( 0.1, @small, @bare, qw(--scene edge:gap=0.5 --light-size 0.1) );
ok( defined $worst && $worst < 0.11, 'no penumbra is cut: ' . ( $worst // '' ) );

# Gaps from nothing to the height of the scene: no fixed width is as near to
# the light's true penumbra.
my @teapot = qw(--size 160x90 --map-size 512 --light-size 0.2);
my ($soft)   = area_error( 0.2, '--soft', @teapot, @bare );
my ($hybrid) = area_error( 0.2, '--soft', @teapot, '--hybrid' );
my ($fixed)  = min map {
    ( area_error( 0.2, @teapot[ 0 .. 3 ], @bare, '--radius', $_ ) )[0]
} 2, 4, 8;
ok( $soft < 0.8 * $fixed,   "--soft is nearer: $soft, fixed $fixed" );
ok( $hybrid < 0.8 * $fixed, "--hybrid is nearer: $hybrid, fixed $fixed" );

# A light without a size has the least disc, 4 texels wide: its standard
# deviation is that of the plain Gaussian of radius 3. Their profiles differ by
# at most 0.04, and the points' from the disc's by 0.083.
note('a light without a size');
my @edge = qw(--scene edge --size 160x90 --map-size 256);
oracle(
    'compare',
    (
        map { dump_run( 5, @edge, @bare, @$_ ) . '/visibility.exr' }
          [qw(--soft --light-size 0)],
        [qw(--blur gaussian --radius 3)]
    ),
    'max=0.123'
);

done_testing;
