# Parallel splits: each is a map like the only one, and where it lies does not
# depend on how the camera moves.
use strict;
use warnings;
use JSON::PP qw(decode_json);
use Test::More;
use VSM;

of_steps( 1 .. 5 );

my @small  = qw(--size 320x180 --map-size 256);
my @avenue = ( @small, qw(--scene avenue --splits 4) );
my %more   = ( 5 => [qw(--bleed-reduction 0)] );

sub check_all {
    my ( $step, @arguments ) = @_;
    return if !is_chosen($step);
    my $dump = dump_run( $step, @arguments, @{ $more{$step} // [] } );
    note("step $step @arguments");
    oracle( $_, $dump ) for qw(files stage matrix rays shading);
    oracle( 'lower', $dump ) if $step == 5;
    return;
}

check_all( $_, @avenue ) for 1, 2, 5, 3, 4;
check_all( 1, @avenue, qw(--splits 8) );
check_all( 2, @avenue, qw(--splits 2 --map-size 300x180) );
check_all( 1, @small, qw(--splits 3) );
check_all( 5, @avenue, qw(--sat) );
oracle( 'stage', dump_run( 5, @avenue, @$_ ) )
  for grep { is_chosen(5) } [qw(--mips)], [qw(--mips --anisotropy 4)];
check_all( 5, @avenue, '--scene', 'avenue:offset=1000,scale=0.01,walk=20' );

# The views of a run: texel size, depth range, and where the middle of the map
# is in the world, in texels along u and v.
sub views_of {
    my ($dump) = @_;
    my $run  = decode_json( slurp("$dump/run.json") );
    my @views;
    for my $view ( @{ $run->{views} } ) {
        my ( @axes, @texels );
        for my $row ( 0, 1 ) {
            my @m      = @{ $view->{map_from_relative}[$row] };
            my $length = sqrt( $m[0]**2 + $m[1]**2 + $m[2]**2 );
            my $side   = $view->{ $row ? 'height' : 'width' };
            my $world  = $m[3];
            $world -= $m[$_] * $run->{origin}[$_] for 0 .. 2;
            push @axes, map { $_ / $length } @m[ 0 .. 2 ];
            push @texels, 1 / ( $length * $side ), ( 0.5 - $world ) * $side;
        }
        push @views,
          {
            axes  => \@axes,
            texel => $texels[0],
            range => $view->{far} - $view->{near},
            place => [ @texels[ 1, 3 ] ],
          };
    }
    return @views;
}

sub near { return abs( $_[0] - $_[1] ) <= $_[2] }

# However the camera walks and turns. The views depend on the picture's shape
# and not on its size.
sub walked {
    my ( $map, $scene ) = @_;
    return dump_run( 1, qw(--size 32x18 --splits 4 --map-size),
        $map, '--scene', $scene );
}

my %moved;

sub check_walk {
    my ( $map, $key ) = @_;
    my ( $there, $here ) = ( walked( $map, 'avenue' ),
        walked( $map, "avenue:$key" ) );
    note("map $map, $key");
    oracle( 'overlap', $there, "other=$here" );
    my @still = views_of($there);
    my @views = views_of($here);
    is( scalar @views, 4, "$key: four views" );
    for my $i ( 0 .. $#views ) {
        my ( $old, $new ) = ( $still[$i], $views[$i] );
        ok( near( $new->{texel} / $old->{texel}, 1, 1e-12 ),
            "$key: split $i keeps the size of its texels" );
        ok( near( $new->{range} / $old->{range}, 1, 1e-12 ),
            "$key: split $i keeps its depth range" );
        my @turned =
          grep { !near( $new->{axes}[$_], $old->{axes}[$_], 1e-12 ) } 0 .. 5;
        ok( !@turned, "$key: split $i does not turn" );
        my @by  = map { $new->{place}[$_] - $old->{place}[$_] } 0, 1;
        my @odd = grep { !near( $_, sprintf( '%.0f', $_ ), 1e-6 ) } @by;
        ok( !@odd, "$key: split $i moves by whole texels: @by" );
        $moved{$map}++ if grep { abs > 0.5 } @by;
    }
    return;
}

my @walks = (
    'walk=0.013', 'walk=0.5',            'aside=-0.7', 'turn=0.1',
    'turn=-7',    'walk=3,turn=20',      'tilt=4',     'tilt=-0.05',
    'turn=50',    'aside=1.1,tilt=-12,turn=-30'
);
check_walk( 256, $_ ) for @walks;
check_walk( 512, $_ ) for @walks[ 1, 2, 4, 9 ];

# The far ones hold all that casts, which does not move.
ok( $moved{256} >= 10, "$moved{256} of 40 views have moved" );
ok( $moved{512} >= 4,  "$moved{512} of 16 views have moved" );
my @still = views_of( walked( 256, 'avenue' ) );

# The nearer to the camera, the finer; none holds more than what casts.
ok( $still[1]{texel} > $still[0]{texel}, 'the second split is coarser' );
ok( $still[$_]{texel} >= $still[ $_ - 1 ]{texel},
    "split $_ has no smaller texels than the one before" )
  for 2, 3;

# RMSE of visibility against what rays say is hard shadow.
sub error_of {
    my ( $step, @options ) = @_;
    my @arguments = qw(--size 320x180 --map-size 512 --scene avenue);
    my $dump =
      dump_run( $step, @arguments, @options, @{ $more{$step} // [] } );
    my $run = ask_oracle( 'errors', $dump, 'rays=4' );
    my ($rmse) = $run->{out} =~ /^hard,(?:[^,]*,){3}([^,]+)/m
      or die "no RMSE against hard shadow: $run->{out}\n";
    return $rmse;
}

# Four maps of the view are at least twice as right as one of all that casts.
for my $step ( grep { is_chosen($_) } 2, 5 ) {
    my $one  = error_of( $step, qw(--splits 1) );
    my $four = error_of( $step, qw(--splits 4) );
    ok( $one >= 2 * $four, "step $step: RMSE $one, with 4 splits $four" );
}

my ( $plain, $layers ) = map { dump_run( 5, @avenue, '--show', $_ ) }
  qw(visibility layer);
ok( slurp("$plain/picture.exr") ne slurp("$layers/picture.exr"),
    '--show layer colours the splits' );

done_testing;
