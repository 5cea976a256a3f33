# --format auto: 16-bit moments only where what they change is bounded by less
# than 1/255, and there it is. The bound that --plan prints holds where it is
# larger, too.
use strict;
use warnings;
use File::Temp qw(tempdir);
use Test::More;
use VSM;

my @small  = qw(--size 160x90 --map-size 128);
my $folder = tempdir( CLEANUP => 1 );

# Whether auto chooses 16 bits, and why.
sub choice {
    my ( $step, @options ) = @_;
    my $run = run_warm( $step, @small, qw(--format auto --plan --output),
        "$folder/a.png", @options );
    return $run->{out} =~ /^16-bit moments +(kept|left out) +0 +0  (.*)$/m
      ? ( $1, $2 )
      : ( 'no choice', $run->{out} . $run->{err} );
}

# Both formats differ by no more than the bound.
sub differs_less {
    my ( $most, @options ) = @_;
    my ( $half, $float ) =
      map { dump_run( 5, @small, @options, '--format', $_ ) } qw(rg16f rg32f);
    oracle(
        'compare',               "$half/visibility.exr",
        "$float/visibility.exr", "max=$most"
    );
    return;
}

# Every scene, as it is and without a blur.
my @scenes = qw(teapot edge edge:gap=0.8 bleed empty thin fence grazing avenue
  stage room crowd:triangles=3000 unlit offstage empty:elevation=90);
my %chosen;
for my $scene (@scenes) {
    for my $more ( [], [qw(--radius 0)] ) {
        my @options = ( '--scene', $scene, @$more );
        my ( $choice, $why ) = choice( 5, @options );
        push @{ $chosen{$choice} }, "$scene @$more";
        differs_less( 1 / 255, @options ) if $choice eq 'kept';
    }
}
is_deeply(
    $chosen{kept},
    [ 'edge:gap=0.8 --radius 0', 'empty:elevation=90 --radius 0' ],
    '16 bits where surfaces are far apart'
);
is( scalar @{ $chosen{'left out'} }, 2 * @scenes - 2, '32 bits elsewhere' );

# What is predicted, against what is.
for my $scene ( 'edge:gap=0.8', 'edge:gap=0.3', 'edge', 'bleed', 'bleed:r=0.5' )
{
    for my $more (
        [qw(--radius 0)],
        [qw(--radius 1 --bleed-reduction 0)],
        [qw(--radius 0 --reduction smooth --bleed-reduction 0.5)]
      )
    {
        my ( undef, $why ) = choice( 5, '--scene', $scene, @$more );
        my ($bound) = $why =~ /^visibility is off by at most ([\d.]+)$/;
        ok( $bound, "$scene @$more: a bound" ) or diag($why) or next;
        differs_less( $bound, '--scene', $scene, @$more );
    }
}

# What there is no bound for.
for my $case (
    [ 3, 'a comparison turns at once' ],
    [ 4, 'a comparison turns at once' ],
    [ 5, 'depths come as near each other as they like' ],
    [ 5, 'nothing is looked up',       qw(--scene empty) ],
    [ 5, '--moments raw',              qw(--moments raw) ],
    [ 5, '--min-variance is not auto', qw(--min-variance 1e-4) ],
    [ 5, 'not known for this filter',  '--mips' ],
    [ 5, 'the light is not parallel',  qw(--scene stage) ],
  )
{
    my ( $step, $why, @options ) = @$case;
    my ( $choice, $found ) = choice( $step, @options );
    is( "$choice: $found", "left out: $why", "step $step @options: 32 bits" );
}

done_testing;
