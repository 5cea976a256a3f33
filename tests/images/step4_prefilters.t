# Step 4's other prefilters: mip-maps, anisotropic lookup, summed-area table.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);
my @bare  = ( @small, qw(--bleed-reduction 0) );

# Every stage from its own input files: the levels, the footprint, the lookup.
# Maps finer than the picture, else every pixel is at level 0.
for my $options (
    [qw(--mips)],
    [qw(--mips --map-size 512 --radius 0)],
    [qw(--mips --map-size 600x360 --blur gaussian)],
    [qw(--mips --downsample 2 --format rg16f)],
    [qw(--mips --anisotropy 16 --map-size 512 --scene fence)],
    [qw(--mips --anisotropy 3 --map-size 512 --radius 0)],
  )
{
    oracle( 'stage', dump_run( 5, @bare, @$options ) );
}
for my $options (
    [qw(--sat)],
    [qw(--sat --radius 0)],
    [qw(--sat --radius 40)],
    [qw(--sat --downsample 2 --radius 15 --map-size 300x180)],
    [qw(--sat --format rg16f)],
  )
{
    my $dump = dump_run( 5, @bare, @$options );
    oracle( $_, $dump ) for qw(files stage lower);
}
for my $options ( ['--mips'], [qw(--mips --anisotropy 8)], ['--sat'] ) {
    my $dump = dump_run( 4, @small, qw(--map-size 512), @$options );
    oracle( $_, $dump ) for qw(files stage);
}

# Two depths under the filter: from the table, too, the bound is the lit share.
for my $options ( [qw(--radius 1)], [qw(--radius 8)], [qw(--downsample 2)] ) {
    oracle( 'edge',
        dump_run( 5, qw(--scene edge --sat), @bare, @$options ) );
}

# What sums the table does not change it.
for my $options ( [], [qw(--map-size 300x180 --scene room --radius 9)] ) {
    same_files(
        "--sat-by compute, fragments @$options",
        (
            map { dump_run( 5, @small, @$options, '--sat', '--sat-by', $_ ) }
              qw(compute fragments)
        ),
        qw(blurred.0 visibility)
    );
}

# What must not change the picture at all, or by no more than the rounding.
sub differs_by_at_most {
    my ( $most, $what, $name, @dumps ) = @_;
    note($what);
    oracle( 'compare', ( map { "$_/$name.exr" } @dumps ), "max=$most" );
    return;
}

# A table's boxes are the blur's. Bound: the blur's 16 roundings, the table's
# 2^-26 per step of 1/49, and its 16.
differs_by_at_most( 4e-6, '--sat is --blur box', 'blurred.0',
    map { dump_run( 4, @small, @$_ ) } ['--sat'], [qw(--blur box)] );

# The levels start from what the blur made. (With mip-maps moments are central.)
my @central = ( @small, qw(--moments central) );
same_files(
    '--mips keeps level 0',
    ( map { dump_run( 5, @central, @$_ ) } [], ['--mips'] ),
    qw(moments.0 blurred.0)
);
same_files(
    '--mips --radius 0 starts with the moments',
    ( map { dump_run( 5, @central, '--radius', 0, @$_ ) } [], ['--mips'] ),
    qw(moments.0 blurred.0)
);

# Where a pixel is smaller than a texel, level 0 is all there is. (Against its
# rounding `auto` adds what the coarsest level can have lost.)
my @near = qw(--size 320x180 --map-size 32 --radius 1 --min-variance 0
  --moments central);
for my $options ( ['--mips'], [qw(--mips --anisotropy 16)] ) {
    differs_by_at_most(
        1e-6, "@$options where pixels are small",
        'visibility', map { dump_run( 5, qw(--scene edge), @near, @$_ ) } [],
        $options
    );
}

# All levels of a plane across the light hold one depth.
my @flat = ( @small, qw(--map-size 512 --show mean --scene) );
for my $options ( ['--mips'], [qw(--mips --anisotropy 16)], ['--sat'] ) {
    differs_by_at_most(
        2e-6,
        "@$options on a flat map",
        'image',
        map { dump_run( 5, @flat, 'empty:elevation=90', @$_ ) } [],
        $options
    );
}

# One tap is trilinear.
same_files(
    '--anisotropy 1 is trilinear',
    (
        map { dump_run( 5, @small, '--mips', @$_ ) } [],
        [qw(--anisotropy 1)]
    ),
    qw(visibility image)
);

done_testing;
