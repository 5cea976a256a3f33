# --msaa: several samples per texel of the map, and their moments.
#
# A sample's depth is that of a place in its texel which its triangle covers. So
# it lies between the least and the largest depth that the triangle has in the
# texel; a triangle perpendicular to the light has only one there. What is
# wrong without `centroid` is a triangle that covers some samples of a texel and
# not its centre: there its plane goes on, on a steep one far away.
use strict;
use warnings;
use JSON::PP qw(decode_json);
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 128);
my @bare  = ( @small, qw(--bleed-reduction 0) );

# Every kind of light and what may be stored. `rays` looks at every sample.
oracle( $_, dump_run( 5, @bare, qw(--msaa 4) ) )
  for qw(files stage matrix rays lower);
for my $options (
    [ 3, qw(--scene stage) ],
    [ 4, qw(--scene room --map-size 96) ],
    [ 3, qw(--scene room --map-size 96 --slope-term --depth projected) ],
    [ 5, qw(--scene avenue --splits 2 --sat) ],
    [ 5, qw(--format rg16f --slope-term) ],
    [ 5, qw(--format rg16f --moments central) ],
    [ 3, '--map-size', '160x96', '--scene', 'teapot:offset=1000,scale=0.01' ],
  )
{
    my ( $step, @words ) = @$options;
    my $dump = dump_run( $step, @small, '--msaa', 4, @words );
    oracle( $_, $dump ) for qw(stage rays);
}

# Where every surface is perpendicular to the light, a texel of both depths is
# between them by the share of its samples, and the visibility is the share of
# the filter's samples that are lit.
for my $options (
    [],
    [qw(--downsample 2 --blur gaussian)],
    [qw(--moments central)]
  )
{
    my $dump = dump_run( 5, @bare, qw(--scene edge --msaa 4), @$options );
    oracle( $_, $dump ) for qw(edge truths);
}
oracle( 'edge',
    dump_run( 5, @bare, qw(--scene edge:gap=0.8 --format rg16f --msaa 4) ) );

# One sample per texel is the map without.
same_files(
    '--msaa 1',
    ( map { dump_run( 5, @small, qw(--scene avenue --splits 2), @$_ ) } [],
        [qw(--msaa 1)] ),
    qw(moments.0 moments.1 visibility)
);

# What it costs in memory: a layer's samples and their depths, once; the map
# needs no depth of its own then.
sub map_bytes {
    my $dump = dump_run( 5, @small, qw(--scene avenue --splits 2), @_ );
    return decode_json( slurp("$dump/run.json") )->{map_bytes};
}
is( map_bytes(qw(--msaa 4)) - map_bytes(),
    4 * 128**2 * ( 8 + 4 ) - 128**2 * 4,
    'map_bytes: four samples, of one layer' );

# What it is for: the silhouette is where it is, not where texels are.
sub footprint_error {
    my $dump = dump_run( 5, @bare, qw(--radius 1), @_ );
    my $run  = ask_oracle( 'errors', $dump, 'rays=64' );
    my ($rmse) = $run->{out} =~ /^footprint,\d+,\d+,\d+,([\d.]+)/m;
    return $rmse // 1;
}
my ( $without, $with ) = map { footprint_error(@$_) } [], [qw(--msaa 4)];
ok( $with < 0.9 * $without,
    "RMSE against the footprint: $without, with --msaa 4 $with" );

done_testing;
