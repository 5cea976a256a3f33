# What step 3 may store besides a linear depth and its square: --depth
# and --slope-term.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);
my @bare  = ( @small, qw(--bleed-reduction 0) );
my @projected = ( @small, qw(--depth projected) );

sub check_all {
    my ( $step, @arguments ) = @_;
    my $dump = dump_run( $step, @arguments );
    note("step $step @arguments");
    oracle( $_, $dump ) for qw(files stage matrix rays);
    return;
}

# z / w in the map and of the receivers, with the slope bias that belongs to it.
check_all( 5, @projected, qw(--scene stage) );
oracle( $_, dump_run( 3, @projected, qw(--scene stage) ) )
  for qw(files stage matrix);
oracle( $_, dump_run( 4, @projected, qw(--scene room) ) ) for qw(stage matrix);
oracle( 'stage', dump_run( 5, @projected, @$_ ) )
  for [qw(--scene stage --format rg16f --sat)], [qw(--light spot --mips)];

# Why the default is linear: where every texel under the filter is shadowed by
# rays, z / w lets more pixels through. Near and far are fitted to the scene,
# which is the best that can be done for z / w.
sub bleeding {
    my ($depth) = @_;
    my $dump = dump_run( 5, @bare, qw(--scene stage --depth), $depth );
    my $run = ask_oracle( 'rays', $dump );
    my ( $bright, $dark ) =
      $run->{out} =~ /shadowed by rays: (\d+) of (\d+) pixels over/
      or return 0;
    return $bright / $dark;
}
my %lit = map { $_ => bleeding($_) } qw(linear projected);
ok(
    $lit{linear} > 0 && $lit{projected} > 1.2 * $lit{linear},
    sprintf 'untruly lit: %.3f of the shadow if linear, %.3f if projected',
    @lit{qw(linear projected)}
);

# A directional light has only one depth.
for my $views ( [], [qw(--scene avenue --splits 2)] ) {
    same_files(
        "projected and linear, @$views",
        ( map { dump_run( 5, @small, @$views, '--depth', $_ ) }
              qw(linear projected) ),
        qw(moments.0 receiver visibility)
    );
}

# The slope across a texel, of the triangle under it and from the next
# fragments. Texels on the edges of triangles are left out: one that a triangle
# does not fill has depths of others in it, which neither form knows.
for my $options (
    [ 3, qw(--scene stage) ],
    [ 3, qw(--scene stage --slope-from derivatives) ],
    [ 5, qw(--scene stage --depth projected --sat) ],
    [ 4, qw(--format rg16f --slope-from derivatives --mips) ],
    [ 3, qw(--scene avenue --splits 2) ],
    [ 3, '--scene', 'teapot:offset=1000,scale=0.01' ],
  )
{
    my ( $step, @words ) = @$options;
    oracle( 'stage', dump_run( $step, @small, '--slope-term', @words ) )
      if is_chosen($step);
}

# What it is for: between the texels of a slope that is lit up, the map has too
# little variance, without any filter and minimum. These pixels go black, where
# rounding takes what there is: central moments keep it.
sub too_dark {
    my $dump = dump_run( 5, @bare, qw(--radius 0 --min-variance 0), @_ );
    my $run = ask_oracle( 'rays', $dump );
    my ($dark) = $run->{out} =~ /lit by rays: (\d+) of/;
    return $dark // -1;
}
my ( $without, $with, $central ) =
  map { too_dark( '--moments', @$_ ) } ['raw'], [qw(raw --slope-term)],
  ['central'];
ok(
    $without > 20 && $with == 0 && $central == 0,
    "lit pixels under 0.98: $without, with the slope term $with, "
      . "of central moments $central"
);

done_testing;
