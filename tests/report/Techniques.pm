# The tables behind `make report`: its modes, scenes and techniques, and why
# some combinations are left out. Sweep.pm turns them into points.
package Techniques;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(%MODES @SCENES $MAP @TECHNIQUES @EXCLUDED $NOT_MEASURED);

# size: of the picture. rays: of each average of the truth, a square number.
# rounds: in each, every program runs once, for so many frames after its
# warm-up. scenes, techniques, widths: only these; map: in place of $MAP; why:
# that is so.
my @PLAIN = qw(hard PCF VSM);
our %MODES = (
    full  => { size => '640x360', rays => 256, rounds => 3, frames => 11 },
    quick => {
        size       => '640x360',
        rays       => 100,
        rounds     => 3,
        frames     => 5,
        scenes     => [qw(teapot edge thin)],
        techniques => \@PLAIN,
        why        => 'is for a first look',
    },
    headline => {
        size       => '640x360',
        rays       => 256,
        rounds     => 3,
        frames     => 11,
        scenes     => ['teapot'],
        techniques => [ @PLAIN, 'moments', 'compared mean' ],
        why        => 'is for the first page',
    },
    tiny => {
        size       => '160x90',
        rays       => 16,
        rounds     => 1,
        frames     => 1,
        scenes     => ['edge'],
        techniques => \@PLAIN,
        widths     => [ 1, 3, 7 ],
        map        => 128,
        why        => 'is for the tests of the report itself',
    },
);

# Texels along each side of the map.
our $MAP = 512;

# option: the scene with keys. map: in place of $MAP, for every technique.
# light_size: of the area light that the soft techniques imitate, world units;
# of a directional light at a distance of 1. pictures: the points that the page
# shows.
my @SHOWN = ( 'hard', 'PCF 7', 'VSM 7', 'VSM 31' );
our @SCENES = (
    {
        name       => 'teapot',
        light_size => 0.05,
        pictures   => [ @SHOWN, 'VSM reduced 7', 'soft', 'soft hybrid' ],
    },
    { name => 'edge', light_size => 0.05, pictures => \@SHOWN },
    {
        name     => 'bleed',
        option   => 'bleed:r=4',
        pictures => [ @SHOWN, 'VSM reduced 31' ],
    },
    { name => 'thin', light_size => 0.05, pictures => \@SHOWN },
    {
        name     => 'fence',
        pictures => [ @SHOWN, 'VSM anisotropic 3, map 2048' ],
    },
    { name => 'stage', light_size => 0.2, pictures => \@SHOWN },
    { name => 'room',  map        => 256, pictures => \@SHOWN },
    {
        name     => 'avenue',
        pictures => [ @SHOWN, 'PCF split in 4 7', 'VSM split in 4 7' ],
    },
    { name => 'crowd', pictures => \@SHOWN },
);

my @ALL    = map { $_->{name} } @SCENES;
my @WIDTHS = ( 3, 7, 15, 31 );
my $BARE   = '--bleed-reduction 0';        # the bound itself
my $RAW    = "--moments raw $BARE";
my $TEST   = "--moments central $BARE";

my $FINE = 'a pixel covers few texels of the map there';
my $SPLIT =
  'one map holds the whole view, or the light is not a directional one';
my $ROUNDING = 'the rounding of the moments shows on the scenes measured';
my $MAP_ONLY = 'its price depends on the map alone, its picture is that of VSM';
my $LIKE_BOX = 'a blur like any other: its error behaves as on those measured';
my $OTHER_WAY =
  'the same picture by another way, whose price depends on the map alone';

# One row: name, family (a colour in the diagrams), step, options (see
# Sweep::filled), widths, scenes, why the others are left out, and maps of
# other sizes: {scene}{size} = widths.
our @TECHNIQUES = map {
    my %row;
    @row{qw(name family step options widths scenes why maps)} = @$_;
    $row{soft} = $row{family} eq 'soft';
    \%row;
} (
    [
        'hard', 'hard', 1, '', [1], \@ALL, '',
        { teapot => { 256 => [1], 1024 => [1] } }
    ],
    [
        'PCF', 'PCF', 2, '--kernel {n}', \@WIDTHS, \@ALL, '',
        { teapot => { 256 => [ 7, 15 ], 1024 => [ 7, 15 ] } }
    ],
    [
        'PCF bilinear', 'PCF', 2,
        '--kernel {n} --bilinear',
        [ 3, 7, 15 ],
        [qw(teapot edge)], 'PCF without its steps, at four times the lookups'
    ],
    [
        'PCF Poisson',
        'PCF',
        2,
        '--kernel {n} --pattern poisson',
        [ 7, 15, 31 ],
        [qw(teapot edge thin)],
        '32 taps on every scene; its noise is as on those measured'
    ],
    [
        'PCF adaptive', 'PCF',
        2,              '--kernel {n} --adaptive',
        [31],           [qw(teapot fence avenue)],
        $FINE
    ],
    [
        'PCF split in 4',
        'PCF', 2,
        '--splits 4 --kernel {n}',
        [ 3, 7, 15 ],
        ['avenue'], $SPLIT
    ],
    [
        'moments', 'hard', 3, '', [1], ['teapot'],
        'hard shadows as in step 1, at the price of the moments'
    ],
    [
        'compared mean',
        'mean', 4, '--radius {r}', [ 7, 31 ],
        ['teapot'],
        'step 4 shows why a filtered depth is wrong: once is enough'
    ],
    [
        'VSM', 'VSM', 5,
        "$TEST --radius {r}",
        \@WIDTHS,
        \@ALL,
        '',
        {
            teapot => { 256  => [ 7, 15 ], 1024 => [ 7, 15 ] },
            fence  => { 2048 => [3] }
        }
    ],
    [
        'VSM reduced',
        'VSM reduced',
        5,
        '--moments central --bleed-reduction 0.18 --radius {r}',
        \@WIDTHS,
        [qw(teapot bleed thin)],
        'measured at every width on teapot, bleed and thin'
    ],
    [
        'VSM reduced smoothly',
        'VSM reduced',
        5,
        '--moments central --bleed-reduction 0.18 --reduction smooth '
          . '--radius {r}',
        [ 7, 31 ],
        [qw(teapot bleed)],
        'it rounds the edges of what is reduced, which shows on those measured'
    ],
    [
        'VSM Gaussian', 'VSM', 5,
        "$TEST --blur gaussian --radius {r}",
        [ 7, 15, 31 ],
        [qw(teapot edge thin)], $LIKE_BOX
    ],
    [
        'VSM binomial', 'VSM',      5, "$TEST --blur binomial",
        [7],            ['teapot'], $LIKE_BOX
    ],
    [
        'VSM boxes', 'VSM', 5,
        "$TEST --blur boxes --radius {r}",
        [ 7, 15, 31 ],
        [qw(teapot edge)], $LIKE_BOX
    ],
    [
        'VSM by fragments',
        'VSM', 5,
        "$TEST --blur-by fragments --radius {r}",
        [ 7, 15, 31 ],
        ['teapot'], $OTHER_WAY
    ],
    [
        'VSM downsampled',
        'VSM', 5,
        "$TEST --downsample 2 --radius {d}",
        [ 7, 15, 31 ],
        [qw(teapot edge thin)], $LIKE_BOX
    ],
    [
        'VSM mips', 'VSM',
        5,          "$TEST --mips --radius {r}",
        [3],        ['fence'],
        $FINE, { fence => { 2048 => [3] } }
    ],
    [
        'VSM anisotropic',
        'VSM', 5,         "$TEST --mips --anisotropy 16 --radius {r}",
        [3],   ['fence'], $FINE, { fence => { 2048 => [3] } }
    ],
    [
        'SAT',         'SAT',
        5,             "$RAW --sat --radius {r}",
        [ 7, 15, 31 ], [qw(teapot edge thin fence avenue)],
        $MAP_ONLY, { teapot => { 256 => [ 7, 15 ], 1024 => [ 7, 15 ] } }
    ],
    [
        'SAT by fragments',
        'SAT', 5,          "$RAW --sat --sat-by fragments --radius {r}",
        [7],   ['teapot'], $OTHER_WAY
    ],
    [
        'SAT adaptive', 'SAT', 5,
        "$RAW --sat --sat-width adaptive --radius {r}",
        [ 15, 31 ],
        [qw(teapot fence avenue)], $FINE
    ],
    map( {
            my ( $name, $options ) = @$_;
            [
                "VSM $name", 'VSM rounded', 5,
                "$options $BARE --radius {r}",
                [ 7, 31 ],
                [qw(teapot edge bleed stage)], $ROUNDING
            ]
        } (
            [ 'raw',      '--moments raw' ],
            [ 'fp16',     '--moments central --format rg16f' ],
            [ 'raw fp16', '--moments raw --format rg16f' ],
        ) ),
    map( { [
                $_->[0],
                'soft',
                5,
                "$_->[1] --light-size {l}",
                [1],
                [qw(teapot edge thin stage)],
                'the width of a penumbra shows on the scenes measured'
        ] }
        (
            [ 'soft',        "$TEST --soft" ],
            [ 'soft hybrid', '--moments central --soft --hybrid' ],
        ) ),
    [
        'VSM multisampled',
        'VSM',
        5,
        "$TEST --msaa 4 --radius {r}",
        [ 3, 7 ],
        [qw(teapot fence)],
        'it is for detail finer than a texel'
    ],
    [
        'VSM deferred',
        'VSM',
        5,
        "$TEST --deferred --radius {r}",
        [7],
        [qw(teapot crowd)],
        'the picture of VSM; what it saves is shading that is drawn over'
    ],
    map( {
            my ( $name, $options, @widths ) = @$_;
            [
                "$name split in 4",
                $name,    5,          "$options --splits 4 --radius {r}",
                \@widths, ['avenue'], $SPLIT
            ]
    } ( [ 'VSM', $TEST, 3, 7, 15 ], [ 'SAT', "$RAW --sat", 7, 15 ] ) ),
);

# What makes no sense although each side exists: a reason, and for which.
our @EXCLUDED = (
    [
        'the filter would be wider than a quarter of the map',
        sub { $_[0]{width} * 4 > $_[0]{map} }
    ],
);

our $NOT_MEASURED = [
    [
        'scene grazing',
        'its light is so low that every pixel counts as a silhouette '
          . '(N.L < 0.1); tests/images/all_scenes.t has its closed form'
    ],
    [
        'scenes empty, unlit, offstage',
        'visibility is 1 or 0 everywhere: nothing to be wrong about'
    ],
    [
        'maps of other sizes on other scenes',
        'how the price grows with the map shows on teapot; fence has one map '
          . 'that is finer than the picture'
    ],
    [
        '--moments central, --format rg32f',
        'every point of step 5 but SAT has them if it is not named raw or fp16'
    ],
    [ '--show',  'it shows a map or a plan, and is no technique' ],
    [ '--light', 'stage has a spot light and room a point light of their own' ],
    [
        '--depth projected, --slope-term, --slope-from, --bias, --slope-bias',
        'step 1\'s bias.md and step 3\'s techniques say what they cost'
    ],
    [
        '--min-variance, --variance-bias, --penumbra-scale',
        'numbers to tune by hand; the defaults are measured'
    ],
    [
        'frames in which little or nothing moves, --move, --keep-all',
        'every frame draws what it needs of its maps (--redraw); a map that '
          . 'is kept costs nothing but the shading'
    ],
    [
        '--sampler hardware',
        'the picture of VSM mips by the texture unit, which llvmpipe only '
          . 'imitates'
    ],
];

1;
