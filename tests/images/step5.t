# Step 5: the Chebyshev bound.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);
my @bare  = ( @small, qw(--bleed-reduction 0) );

for my $scene (qw(teapot edge bleed empty)) {
    my $dump = dump_run( 5, '--scene', $scene, @bare );
    oracle( $_, $dump ) for qw(files stage matrix rays lower);
}

# Two depths under the filter: the bound is the lit share.
for my $options (
    [qw(--radius 0)],
    [qw(--radius 1)],
    [qw(--radius 8)],
    [qw(--downsample 2)]
  )
{
    my $dump = dump_run( 5, '--scene', 'edge', @bare, @$options );
    oracle( $_, $dump ) for qw(edge lower);
    oracle( 'stage', dump_run( 5, @bare, @$options ) );
}

# Three depths: how far the bound is off, known in closed form.
for my $ratio ( 1, 2, 4 ) {
    my $dump = dump_run( 5, '--scene', "bleed:r=$ratio", @bare );
    oracle( 'bleed', $dump, "r=$ratio" );
}

for my $options (
    [qw(--moments raw)],
    [qw(--moments raw --downsample 4 --radius 1)],
    [qw(--bleed-reduction 0.18)],
    [qw(--bleed-reduction 0.9)],
    [qw(--bleed-reduction 0.3 --reduction smooth)],
    [qw(--variance-bias 1e-4)],
    [qw(--variance-bias 1 --min-variance 1)],
    [qw(--min-variance 0)],
    [qw(--min-variance 1e-3)],
    [qw(--map-size 300x180)],
    [qw(--scene teapot:elevation=20)],
    [ '--scene', 'teapot:offset=1000,scale=0.01' ],
  )
{
    oracle( 'stage', dump_run( 5, @bare, @$options ) );
}

same_files(
    'step 5 filters as step 4',
    dump_run( 4, @small ),
    dump_run( 5, @small, qw(--moments raw) ),
    qw(moments.0 blurred.0)
);

done_testing;
