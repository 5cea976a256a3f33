# The extreme cases of stability.pl, but for those without a picture (cases.c).
package Cases;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(@cases);

# name, and what there is to know:
#   options  of every step           not     {n => reason}
#   step     {n => [options]} more
#   formats  1: fp16 as well         quick   the steps in `make test`
#   map, size  in place of the small ones
#   minimums in place of both kinds of least variance
#   closed   1: compare with the closed form of scene edge
#   picture  options of the run whose picture it has to be within 1/255 of
#   refused  {n => pattern}: exits with one line that matches
our @cases;

sub scene_case {
    my ( $name, $scene, %case ) = @_;
    my @options = ( '--scene', $scene, @{ delete $case{options} // [] } );
    push @cases, { name => $name, options => \@options, %case };
    return;
}

my %NO_FILTER = map { $_ => 'no filter' } 1, 3;
my %ONLY_5    = map { $_ => 'no such option before step 5' } 1 .. 4;

for my $decade ( 1 .. 6 ) {
    scene_case( "near:far 1:1e$decade, linear", "lamp:ratio=1e$decade" );
    scene_case(
        "near:far 1:1e$decade, projected",
        "lamp:ratio=1e$decade",
        step => { map { $_ => [qw(--depth projected)] } 3 .. 5 },
        not  => { map { $_ => 'depth is linear' } 1, 2 },
    );
}
for my $decade ( 1 .. 6 ) {
    scene_case(
        "gap 1e-$decade",
        "edge:gap=1e-$decade",
        formats => 1,
        closed  => 1,
        quick   => $decade == 2 ? [5] : [],
    );
}
for my $offset (qw(0 1e3 1e5 1e7)) {
    scene_case(
        "offset $offset", "teapot:offset=$offset",
        picture => $offset ? [qw(--scene teapot)] : undef,
        quick   => $offset eq '1e7' ? [ 1 .. 5 ] : [],
    );
}
for my $scale (qw(1e-4 1e-2 1e2 1e4)) {
    scene_case( "scale $scale", "teapot:scale=$scale",
        picture => [qw(--scene teapot)] );
}
for my $degrees (qw(90 1 0.1 0.01)) {
    my $along = $degrees == 90 ? ', along up' : '';
    scene_case( "light at $degrees degrees$along",
        "teapot:elevation=$degrees",
        quick => $degrees eq '0.01' ? [ 4, 5 ] : [] );
}
scene_case( 'camera and light along up', 'overhead' );
scene_case( 'light inside an occluder',  'enclosed' );
scene_case( 'spot inside an occluder', 'enclosed',
    options => [qw(--light spot)] );
scene_case( 'camera at the light',       'headlamp' );
scene_case( 'coplanar faces',            'coplanar' );
scene_case( 'zero-area triangles',       'slivers' );
scene_case( 'caster through the near plane', 'cut' );
scene_case( 'receiver outside the map',  'edge' );
scene_case( 'depth outside [0, 1] before the blur', 'cut:near=9.5,far=10',
    quick => [ 1, 5 ] );
scene_case( 'map 1x1', 'teapot', map => '1x1',
    step => { map { $_ => [qw(--radius 0)] } 4, 5 } );
scene_case( 'map 1x300', 'teapot', map => '1x300',
    step => { map { $_ => [qw(--radius 0)] } 4, 5 } );
scene_case( 'map 300x1', 'teapot', map => '300x1',
    step => { map { $_ => [qw(--radius 0)] } 4, 5 } );
scene_case( 'map 131x77', 'teapot', map => '131x77' );
scene_case( 'map of the driver\'s limit, 8 high', 'teapot',
    map => 'LIMITx8' );
scene_case( 'map beyond the driver\'s limit', 'teapot', map => 'BEYONDx8',
    refused => { map { $_ => qr/--map-size .*limit/ } 1 .. 5 } );
for my $radius ( 0, 1, 64 ) {
    my $width = 2 * $radius + 1;
    scene_case(
        "radius $radius", 'teapot',
        map  => 384,
        not  => {%NO_FILTER},
        step => {
            2 => [ '--kernel', $width ],
            map { $_ => [ '--radius', $radius ] } 4, 5
        },
    );
}
scene_case( 'radius wider than the map', 'teapot',
    not  => { %NO_FILTER, 2 => 'outside the map is lit' },
    step => { map { $_ => [qw(--radius 64)] } 4, 5 },
    refused => { map { $_ => qr/--radius 64 is wider than the map/ } 4, 5 },
);
scene_case( 'gaussian, radius 16', 'teapot',
    not  => { %NO_FILTER, 2 => 'its taps weigh the same' },
    step => { map { $_ => [qw(--blur gaussian --radius 16)] } 4, 5 } );
scene_case( 'downsampled', 'teapot',
    not  => { map { $_ => 'no downsampling before step 4' } 1 .. 3 },
    step => { map { $_ => [qw(--downsample 2)] } 4, 5 } );
scene_case( "spot cone $_ degrees", "lamp:cone=$_" ) for qw(0.1 1);
# So wide that the plate covers a few texels only.
scene_case( 'spot cone 179 degrees', 'lamp:cone=179', map => 1024,
    step => { map { $_ => [qw(--radius 1)] } 4, 5 } );
scene_case( 'point light', 'room' );
scene_case( 'four splits', 'avenue', options => [qw(--splits 4)] );
scene_case( 'min variance 0', 'teapot', not => {%ONLY_5},
    minimums => [0], formats => 1 );
scene_case( 'bleed reduction just under 1', 'teapot', not => {%ONLY_5},
    step => { 5 => [qw(--bleed-reduction 0.9999)] } );
scene_case( 'bleed reduction 1', 'teapot', not => {%ONLY_5},
    step     => { 5 => [qw(--bleed-reduction 1)] },
    minimums => ['auto'],
    refused => { 5 => qr/--bleed-reduction/ } );
for ( [ 1, 'not a number' ], [ 2, 'infinite' ] ) {
    my ( $vertex, $what ) = @$_;
    scene_case( "a vertex that is $what", "broken:vertex=$vertex",
        refused => { map { $_ => qr/object 'sail': .*not finite/ } 1 .. 5 },
        quick   => [ $vertex == 1 ? 1 : () ] );
}
scene_case( 'a far caster stretches the range 1e4 times',
    'stiff:gap=1e-5,aside=3' );
scene_case( 'gaps of 0.9 and 1e-5 under one filter', 'stiff:gap=1e-5',
    formats => 1 );
scene_case( '1 mm on a floor of 1 km', 'speck' );

1;
