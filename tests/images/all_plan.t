# What is left out changes no pixel: the same bytes with and without --keep-all,
# of the picture and of everything that it was made from. The maps under it are
# not compared: a dump draws them whole. VSM_ALL=1 (make identical): every scene
# in every step and with every filter.
use strict;
use warnings;
use File::Temp qw(tempdir);
use Test::More;
use VSM;

of_steps( 1 .. 5 );

my @small = qw(--size 160x90 --map-size 128);
my @files = qw(picture image visibility receiver position normal);

# One test: the pictures of a run and of the same with --keep-all.
sub same_pixels {
    my ( $step, @options ) = @_;
    return if !is_chosen($step);
    my $with    = dump_run( $step, @small, @options );
    my $without = dump_run( $step, @small, @options, '--keep-all' );
    my @differ =
      grep { slurp("$with/$_.exr") ne slurp("$without/$_.exr") } @files;
    is( "@differ", '', "step $step @options: the same pixels" );
    return;
}

# Turned so far, the camera sees into four of the light's six views, two of them
# at their edge.
my $turned = 'room:turn=-60';
my @scenes = (
    qw(teapot edge bleed empty thin fence grazing avenue stage room), $turned,
    qw(crowd:triangles=3000 unlit offstage)
);

for my $step ( 1 .. 5 ) {
    my @some = $step == 5 ? qw(teapot stage unlit offstage) : ();
    same_pixels( $step, '--scene', $_ )
      for $ENV{VSM_ALL} ? @scenes : ( $turned, @some );
}
same_pixels( 2, qw(--scene avenue:turn=40 --splits 4) );

# Of what is behind the camera or beside the picture nothing is drawn.
for ( [ '<', 97 ], [ '==', 97, '--keep-all' ] ) {
    my ( $relation, $all, @options ) = @$_;
    my $out = tempdir( CLEANUP => 1 ) . '/a.png';
    my $run = run( 1, @small, qw(--scene avenue:turn=40 --plan --output),
        $out, @options );
    my ($drawn) = $run->{out} =~ /^picture +kept .* (\d+) of $all objects/m;
    cmp_ok( $drawn // -1, $relation, $all,
        "avenue:turn=40 @options: objects drawn, of $all" );
}

# What else is kept or left out, and why.
for (
    [ 1, 'derivatives',          'left out' ],
    [ 2, 'derivatives',          'kept', '--adaptive' ],
    [ 5, 'derivatives',          'kept', '--mips' ],
    [ 5, 'maps in later frames', 'left out' ],
    [ 5, 'maps in later frames', 'kept', '--redraw' ],
    [ 5, 'G-buffer',             'kept', '--deferred' ],
    [ 5, 'summed-area table',    'kept', '--sat' ],
    [ 5, 'blur',                 'left out', '--sat' ],
    [ 5, 'central moments',      'left out' ],
    [ 5, 'central moments',      'kept', '--mips' ],
  )
{
    my ( $step, $pass, $decision, @options ) = @$_;
    next if !is_chosen($step);
    my $run = run_warm( $step, @small, '--plan', '--output',
        tempdir( CLEANUP => 1 ) . '/a.png', @options );
    like( $run->{out}, qr/^\Q$pass\E +$decision +\d+ +\d+  \S/m,
        "step $step @options: $pass is $decision" );
}

# What nobody asked for is no row.
my $rows = run_warm( 5, @small, qw(--plan --radius 0) )->{out};
unlike( $rows, qr/^(?:$_)/m, "step 5: no row for $_" )
  for 'G-buffer', 'blur', 'downsampling', 'mip-map levels';

# Steps 1 and 2 do not draw the floor below all that the camera sees. Moments
# need it, and so does a bias that pushes what is seen behind it.
for (
    [ 1, 1 ], [ 2, 1 ], [ 3, 0 ],
    [ 1, 0, '--bias',       '-0.5' ],
    [ 2, 0, '--slope-bias', '-30' ],
    [ 1, 0, '--keep-all' ]
  )
{
    my ( $step, $behind, @options ) = @$_;
    my $run = run_warm( $step, @small, qw(--scene avenue:tilt=30 --plan),
        '--output', tempdir( CLEANUP => 1 ) . '/a.png', @options );
    is( scalar( $run->{out} =~ /; \d+ behind all receivers$/m ) || 0,
        $behind, "step $step @options: behind all receivers" );
    same_pixels( $step, qw(--scene avenue:tilt=30), @options )
      unless "@options" =~ /keep/;
}

# A plane alone is not looked up; where it can shadow itself it is: without a
# bias or with a negative one, and where it hardly varies across the filter.
for my $step ( 1 .. 5 ) {
    same_pixels( $step, qw(--scene empty) );
    same_pixels( $step, qw(--scene grazing --splits 2) ) if $ENV{VSM_ALL};
}
same_pixels( 1, qw(--scene empty --slope-bias 0) );
same_pixels( 2, qw(--scene empty --bias -0.02) );
same_pixels( 5, qw(--scene empty:elevation=89.9 --radius 1) );
same_pixels( 5, qw(--scene offstage --light point) );

# Every pass of the filter, and every lookup, in rectangles.
my @filters = (
    [qw(--radius 0)],
    [qw(--blur gaussian --radius 9 --downsample 2)],
    [qw(--blur boxes --radius 10)],
    [qw(--blur boxes --radius 10 --blur-by fragments)],
    [qw(--mips --anisotropy 8)],
    [qw(--sat)],
    [qw(--sat --sat-by fragments --sat-width adaptive)],
    [qw(--msaa 4 --mips --radius 0)],
    [qw(--soft --hybrid)],
    [qw(--deferred --format rg16f --slope-term)],
);
my @more = (
    [qw(--soft)],
    [qw(--mips --sampler hardware)],
    [qw(--moments raw --blur boxes --radius 4 --mips)],
    [qw(--blur binomial)],
    [qw(--depth projected)],
    [qw(--moments raw --slope-term --slope-from derivatives)],
);
for my $options ( @filters, $ENV{VSM_ALL} ? @more : () ) {
    same_pixels( 5, '--scene', $_, @$options )
      for $ENV{VSM_ALL} ? @scenes : $turned;
}

# What moves moves its shadow: nothing is left of the frame before.
for (
    [ 5, qw(room --move ball) ],
    [ 1, qw(room --move wall) ],
    [ 4, qw(teapot --move teapot) ],
    [ 5, qw(empty --move floor) ],
    [ 2, qw(avenue --splits 3 --move column) ]
  )
{
    my ( $step, @options ) = @$_;
    my ( $with, $without ) = map {
        my $picture = tempdir( CLEANUP => 1 ) . '/a.exr';
        run_warm( $step, @small, qw(--bench 2 --output),
            $picture, '--scene', @options, @$_ );
        slurp($picture);
    } [], ['--keep-all'];
    ok( $with eq $without, "step $step @options: the same pixels" );
}

# Where nothing casts or is lit a frame is that of --shadows off: no pass more,
# and none that touches more. (`make saved` takes the times.)
sub passes {
    my ( $step, @options ) = @_;
    my $run = run_warm( $step, @small, qw(--bench 1 --output),
        tempdir( CLEANUP => 1 ) . '/a.png', @options );
    my ( undef, @rows ) = split /\n/, $run->{out};
    @rows or die "step $step @options: no times\n";
    return join "\n", map { join ',', ( split /,/ )[ 0, 6, 7 ] } @rows;
}
for my $step ( 1 .. 5 ) {
    is(
        passes( $step, '--scene', $_ ),
        passes( $step, '--scene', $_, qw(--shadows off) ),
        "step $step, $_: the passes of --shadows off"
    ) for qw(empty unlit offstage);
}

# The camera before one wall, with the maps drawn in every frame: the passes
# touch about a tenth of the texels. (`make saved` takes the times.)
my ( $planned, $kept ) = map {
    my $run = run_warm( 5, qw(--scene room:turn=-100 --bench 1 --map-size 256),
        qw(--size 320x180 --output), tempdir( CLEANUP => 1 ) . '/a.png', $_ );
    my ($texels) = $run->{out} =~ /^total,(?:[^,]*,){5}(\d+),/m
      or die "no texels: $run->{err}\n";
    $texels;
} qw(--redraw --keep-all);
cmp_ok( 8 * $planned, '<', $kept,
    'one wall of a room: less than an eighth of the texels' );

done_testing;
