# The texels and bytes that --bench says each pass touches: what it writes, and
# the bytes of that and of what it reads of the pass before it, once per draw.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

# {pass}[texels, bytes] of a picture of 32x18 and maps of 64x64.
sub touched {
    my ( $step, @options ) = @_;
    my $run = run( $step,
        qw(--size 32x18 --map-size 64 --bench 1 --output a.png), @options );
    my ( $head, @lines ) = split /\n/, $run->{out};
    like(
        $head // '',
qr/^pass,median_ms,quartile1_ms,quartile3_ms,frames,clock,texels,bytes,/,
        "step $step @options: the columns"
    ) or diag( $run->{err} );
    return { map { my @cells = split /,/; $cells[0] => [ @cells[ 6, 7 ] ] }
          @lines };
}

my ( $pixels, $texels ) = ( 32 * 18, 64 * 64 );
my $shading = [ $pixels, $pixels * ( 16 + 4 ) ];    # colour, depth
my @all     = qw(--keep-all);

# Depth twice: as the map's texel and for the depth test.
is_deeply(
    touched( 1, @all ),
    {
        depth   => [ $texels, $texels * ( 4 + 4 ) ],
        shading => $shading,
        total   => [ $texels + $pixels, $texels * 8 + $pixels * 20 ],
    },
    'step 1: a map, a picture, and both'
);

# Six layers; along u and along v every texel is read and written.
my $found = touched( 4, @all, qw(--scene room --format rg16f) );
is_deeply(
    $found->{moments},
    [ 6 * $texels, 6 * $texels * ( 4 + 4 ) ],
    'moments of 16 bits, of six layers'
);
is_deeply(
    $found->{blur},
    [ 12 * $texels, 12 * $texels * ( 4 + 4 ) ],
    'two passes of a blur'
);

# Four samples with a depth each, then a texel from four samples. A group of
# four becomes one; three boxes along each axis; and levels of a quarter each,
# whose texels are made of four.
my $small  = $texels / 4;
my $levels = 16**2 + 8**2 + 4**2 + 2**2 + 1;
$found = touched( 5, @all,
    qw(--msaa 4 --downsample 2 --blur boxes --radius 4 --mips --deferred) );
is_deeply(
    $found->{moments},
    [ 5 * $texels, $texels * ( 4 * ( 8 + 4 ) + 8 + 4 * 8 ) ],
    'samples, and texels of them'
);
is_deeply(
    $found->{blur},
    [
        ( 1 + 6 ) * $small + $levels,
        $small * ( 5 * 8 + 6 * 2 * 8 ) + $levels * 5 * 8
    ],
    'downsampling, three boxes and mip-maps'
);
my $attributes =
  ( $found->{shading}[1] - $pixels * ( 16 + 4 ) ) / ( $pixels * 2 * 16 );
is_deeply(
    $found->{shading},
    [ 2 * $pixels, $pixels * ( 16 + 4 ) + int($attributes) * $pixels * 2 * 16 ],
    'a G-buffer, written and read'
);
cmp_ok( $attributes, '>=', 3, 'position, normal and albedo' );

# From the map, then along the other axis; or along each axis three times, for
# sums of 4, 16 and 64.
for ( [ compute => 1 ], [ fragments => 6 ] ) {
    my ( $by, $more ) = @$_;
    $found = touched( 4, @all, qw(--sat --sat-by), $by );
    is_deeply(
        $found->{blur},
        [
            ( 1 + $more ) * $texels,
            $texels * ( 8 + 8 ) + $more * $texels * ( 8 + 8 )
        ],
        "a table by $by"
    );
}

# What the plan leaves out is not touched.
$found = touched( 5, qw(--scene room:turn=180 --redraw) );
for (qw(moments blur)) {
    my $most = 6 * $texels * ( $_ eq 'blur' ? 2 : 1 );
    cmp_ok( $found->{$_}[0], '<', $most, "$_: fewer texels than there are" );
    cmp_ok( $found->{$_}[0], '>', 0,     "$_: but some" );
}
is_deeply(
    [ @{ touched(5) }{qw(moments blur)} ],
    [ [ 0, 0 ], [ 0, 0 ] ],
    'an unchanged map is not drawn again'
);


# Where something moves only the layers that hold it are drawn again.
my ( $some, $every ) =
  map { touched( 5, qw(--scene room --move ball), @$_ ) } [], ['--redraw'];
for (qw(moments blur)) {
    cmp_ok( $some->{$_}[0], '>', 0, "$_: drawn again where something moves" );
    cmp_ok( 1.5 * $some->{$_}[0], '<', $every->{$_}[0],
        "$_: but not where nothing does" );
}

done_testing;
