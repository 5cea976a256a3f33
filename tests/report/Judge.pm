# What the measured points say: the Pareto front, and the claims that have to
# hold on every machine.
package Judge;

use strict;
use warnings;

use Exporter   qw(import);
use List::Util qw(sum0);
use Measure    qw(quantile);

our @EXPORT_OK = qw(mark_front claims ratio);

# Whether one point is clearly faster than another, beyond both quartiles, and
# no more wrong. Medians alone would let noise decide between equals.
sub beats {
    my ( $this, $that ) = @_;
    return $this->{total_q3} < $that->{total_q1}
      && $this->{footprint_rmse} <= $that->{footprint_rmse};
}

sub mark_front {
    my @points =
      grep { defined $_->{total_ms} && defined $_->{footprint_rmse} } @_;
    for my $point (@points) {
        $point->{front} = 1;
        for (@points) {
            $point->{front} = 0
              if $_->{scene} eq $point->{scene} && beats( $_, $point );
        }
    }
    return;
}

# How much longer a pass of one point takes than another's: round by round,
# since the machine may be slower in one round than in the next; then the
# median.
sub ratio {
    my ( $pass, $point, $other ) = @_;
    my ( $these, $those ) = map { $_->{medians}{$pass} } $point, $other;
    my $rounds = @$these < @$those ? @$these : @$those;
    return quantile( 0.5,
        map { $these->[$_] / $those->[$_] } 0 .. $rounds - 1 );
}

# The same of their fastest frames. Whatever else the machine does only adds to
# a frame's time, so the least time is the one that depends on it least: what
# has to hold is judged by it, since it has to hold on a busy machine too.
sub fastest_ratio {
    my ( $pass, $point, $other ) = @_;
    return $point->{fastest}{$pass} / $other->{fastest}{$pass};
}

# Each: {holds, text}; of points that were not measured, nothing.
sub claims {
    my @points = @_;
    my %point  = map { ( "$_->{scene} $_->{label}" => $_ ) }
      grep { !$_->{missing} } @points;
    my @claims;
    my $claim = sub {
        my ( $holds, $format, @values ) = @_;
        push @claims,
          { holds => $holds ? 1 : 0, text => sprintf $format, @values };
    };
    my $pick = sub {
        my @found = map { $point{$_} } @_;
        return grep( { !$_ } @found ) ? () : @found;
    };
    my $bad = sum0( map { $_->{footprint_nonfinite} // 0 } values %point );
    $claim->( $bad == 0, 'values that are not finite: %d', $bad );
    my %scenes = map { $_->{scene} => 1 } @points;
    for my $scene ( sort keys %scenes ) {
        for ( [ 'PCF', 8, 1e9 ], [ 'VSM', 0, 1.2 ] ) {
            my ( $name, $least, $most ) = @$_;
            my ( $wide, $narrow ) =
              $pick->( "$scene $name 31", "$scene $name 7" )
              or next;
            my $ratio = fastest_ratio( 'shading', $wide, $narrow );
            $claim->(
                $ratio >= $least && $ratio <= $most,
                '%s: shading, %s 31 over %s 7, fastest frames: %.2f',
                $scene, $name, $name, $ratio
            );
        }
    }
    for my $width ( 3, 7, 15, 31 ) {
        for ( $pick->("edge VSM $width") ) {
            $claim->(
                $_->{pcf_rmse} < 1e-4,
                'edge: VSM %d against same-weights PCF: RMSE %.2g',
                $width, $_->{pcf_rmse}
            );
        }
        for ( $pick->("bleed VSM $width") ) {
            my $formula = ( 4 / 6 )**2;
            $claim->(
                abs( $_->{pcf_max} / $formula - 1 ) <= 0.02,
                'bleed, r = 4: largest error of VSM %d: %.4f, formula %.4f',
                $width,
                $_->{pcf_max},
                $formula
            );
        }
    }

    # The steps' own defaults are 7 texels wide. Wider VSM need not be nearer
    # than hard shadows: the bound's own error grows with the width.
    for my $name ( 'PCF 7', 'VSM 7' ) {
        my ( $point, $hard ) = $pick->( "teapot $name", 'teapot hard' )
          or next;
        $claim->(
            $point->{footprint_rmse} < $hard->{footprint_rmse},
'teapot: %s is nearer to footprint truth than hard: RMSE %.4f, %.4f',
            $name,
            $point->{footprint_rmse},
            $hard->{footprint_rmse}
        );
    }
    return @claims;
}

1;
