# The truths themselves, where the answer is known by construction, and the
# stages' kernels and formats that only the oracle tells apart.
use strict;
use warnings;
use Test::More;
use VSM;

of_steps(5);

my @small = qw(--size 320x180 --map-size 256);
my @bare  = ( @small, qw(--bleed-reduction 0) );

# The errors of a dump; one test that the table is whole.
sub errors_of {
    my ( $dump, $truths, @arguments ) = @_;
    my %errors = oracle_errors( $dump, @arguments );
    is( "@{[sort keys %errors]}", $truths, "errors: the truths of this step" );
    is( ( grep { $_->{nonfinite} != 0 || $_->{pixels} == 0 } values %errors ),
        0, 'errors: finite, and something to count' );
    return %errors;
}

sub at_most {
    my ( $value, $most, $name ) = @_;
    ok( $value <= $most, "$name: $value, at most $most" );
    return;
}

# Kernels and formats, stage by stage.
for my $options (
    [qw(--blur gaussian)],
    [qw(--blur gaussian --radius 1)],
    [qw(--blur gaussian --radius 8 --downsample 2)],
    [qw(--blur binomial)],
    [qw(--format rg16f)],
    [qw(--format rg16f --radius 0)],
    [qw(--format rg16f --blur gaussian --downsample 2)],
  )
{
    my $dump = dump_run( 5, @bare, @$options );
    oracle( $_, $dump ) for qw(files stage rays lower);
}
oracle( 'stage', dump_run( 3, @small, qw(--format rg16f) ) );
oracle( 'stage', dump_run( 4, @small, qw(--format rg16f --blur binomial) ) );

# Two depths: the lit share, whatever the kernel; in 16 bits where the gap is
# wide enough for it.
for my $options (
    [qw(--scene edge --blur gaussian --radius 6)],
    [qw(--scene edge --blur binomial --downsample 2)],
    [qw(--scene edge:gap=0.8 --format rg16f)],
  )
{
    oracle( 'edge', dump_run( 5, @bare, @$options ) );
}
for my $kernel ( 1, 7 ) {
    my @soft = ( @small, '--bilinear', '--kernel', $kernel );
    my $dump = dump_run( 2, @soft );
    oracle( $_, $dump ) for qw(files stage rays);
    oracle( 'edge', dump_run( 2, '--scene', 'edge', @soft ) );
}

# Closed forms of every truth, for every step's kernel.
for my $options (
    [ 1, @small ],
    [ 2, @small ],
    [ 2, @small, qw(--bilinear --kernel 1) ],
    [ 2, @small, qw(--bilinear --kernel 15) ],
    [ 3, @small ],
    [ 4, @small, qw(--blur binomial) ],
    [ 5, @bare ],
    [ 5, @bare,  qw(--blur gaussian --radius 6 --downsample 2) ],
  )
{
    my ( $step, @options ) = @$options;
    oracle( 'truths', dump_run( $step, '--scene', 'edge', @options ) );
}
oracle( 'truths', dump_run( 5, '--scene', 'bleed', @bare ) );
oracle( 'truths', dump_run( 5, '--scene', 'empty', @bare ) );
oracle( 'truths', dump_run( 5, '--scene', 'empty', '--light', $_, @bare ) )
  for qw(spot point);
oracle( 'truths', dump_run( 4, '--scene', 'teapot:elevation=90', @small ) );

# A hard shadow map of surfaces perpendicular to the light, its bias aside, is
# its own same-weights truth.
my %hard = errors_of( dump_run( 1, '--scene', 'edge', @small ),
    'area footprint hard pcf', 'light-size=0.2' );
at_most( $hard{pcf}{max}, 0, 'step 1, edge, pcf: largest' );

# Two depths: the bound is exact (a texel at the outline, which the
# rasteriser moves by up to 1/256, may differ by its weight).
my %edge = errors_of( dump_run( 5, '--scene', 'edge', @bare ),
    'footprint hard lower pcf' );
at_most( $edge{pcf}{rmse}, 1e-4, 'step 5, edge, pcf: RMSE' );

# Three depths: (r/(r+2))^2 too bright at worst.
my %bleed = errors_of( dump_run( 5, '--scene', 'bleed:r=4', @bare ),
    'footprint hard lower pcf' );
at_most( abs( $bleed{pcf}{max} - 4 / 9 ),
    0.02 * 4 / 9, 'step 5, bleed, pcf: largest, from 4/9' );

# Filtering brings a picture nearer to its own filter than not filtering.
my %rmse;
for my $step ( 1, 2, 5 ) {
    my @options = $step == 5 ? @bare : @small;
    my %errors  = errors_of( dump_run( $step, @options ),
        ( $step == 5 ? 'footprint hard lower pcf' : 'footprint hard pcf' ) );
    $rmse{$step} = $errors{footprint}{rmse};
}
at_most( $rmse{$_}, $rmse{1}, "teapot, footprint: step $_ against step 1" )
  for 2, 5;

# Errors are errors: of a picture that is 0.25 off everywhere.
SKIP: {
    my $dump = dump_run( 1, '--scene', 'empty', @small );
    my $copy = "$dump/broken";
    mkdir $copy or skip "cannot make $copy: $!", 1;
    spew( "$copy/$_", slurp("$dump/$_") )
      for qw(run.json receiver.exr position.exr normal.exr depth.0.exr);
    command( 'oiiotool', "$dump/visibility.exr", '--subc', 0.25, '-o',
        "$copy/visibility.exr" );
    my %errors = errors_of( $copy, 'footprint hard pcf', "write=$copy/out" );
    is( join( ' ', map { "@{$_}{qw(rmse p99 max share)}" } values %errors ),
        join( ' ', ('0.25 0.25 0.25 1') x 3 ),
        'errors: a quarter off everywhere' );
    my @files = map { ( "error.$_.bin", "error.$_.exr", "truth.$_.exr" ) }
      qw(footprint hard pcf);
    is( "@{[everything_below(\"$copy/out\")]}",
        "@{[sort @files]}", 'errors: writes its pictures' );
    is( slurp("$copy/out/error.hard.bin"),
        pack( 'f*', (-0.25) x ( 320 * 180 ) ),
        'errors: bare floats, all of them' );
}

done_testing;
