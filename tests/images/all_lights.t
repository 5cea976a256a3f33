# Spot and point lights: the same stages, seen through one view and through
# six. The last views that a test needs come first: mutants stop early.
use strict;
use warnings;
use Test::More;
use VSM;

of_steps( 1 .. 5 );

my @small = qw(--size 320x180 --map-size 256);
my %more  = ( 5 => [qw(--bleed-reduction 0)] );

sub check_all {
    my ( $step, @arguments ) = @_;
    return if !is_chosen($step);
    my $dump = dump_run( $step, @small, @{ $more{$step} // [] }, @arguments );
    note("step $step @arguments");
    oracle( $_, $dump ) for qw(files stage matrix rays shading);
    oracle( 'lower', $dump ) if $step == 5;
    return;
}

for my $step ( 1 .. 5 ) {
    check_all( $step, @$_ )
      for [qw(--scene room)], [qw(--scene stage)], [qw(--light spot)],
      [qw(--light point)];
}

# Wider filters, other maps, a world that is small and far away, a light that
# is raised, and one that is made parallel.
check_all( 2, qw(--scene room --kernel 15) );
check_all( 2, qw(--scene stage --bilinear) );
check_all( 2, qw(--scene room --map-size 300x180) );
check_all( 5, qw(--scene room --radius 8 --downsample 2) );
check_all( 5, qw(--scene stage --blur gaussian --map-size 180x300) );
check_all( 5, qw(--scene room --sat) );
oracle( 'stage', dump_run( 5, @small, @$_ ) )
  for grep { is_chosen(5) } [qw(--scene room --mips)],
  [qw(--scene stage --mips --anisotropy 4)];
check_all( 1, '--scene', 'room:offset=1000,scale=0.01' );
check_all( 1, '--scene', 'stage:elevation=70' );
check_all( 1, qw(--scene room --light directional) );
check_all( 1, qw(--scene stage --light point) );

done_testing;
