# What the measured points say: the Pareto front, and the claims that have to
# hold on every machine.
package Judge;

use strict;
use warnings;

use Exporter   qw(import);
use List::Util qw(max min sum0);
use Measure    qw(quantile);

our @EXPORT_OK = qw(mark_front claims outcome ratio busy lies_between spread);

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

# A warning where something else kept the machine busy: of half the points the
# third quartile is over 1.3 times the first, which else is nearer to 1.05.
sub busy {
    my @timed = grep { $_->{total_q1} } @_ or return '';
    my $spread =
      quantile( 0.5, map { $_->{total_q3} / $_->{total_q1} } @timed );
    return $spread <= 1.3
      ? ''
      : sprintf 'The machine was busy: half of the times vary by a factor of '
      . '%.1f or more between their quartiles. Take them as a hint.', $spread;
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

# The least and the most that the ratio of two times may be, each between the
# lesser and the greater of two. Nothing bounds it where one may be 0.
sub spread {
    my ( $these, $those ) = @_;
    return (
        $those->[1] > 0 ? $these->[0] / $those->[1] : 0,
        $those->[0] > 0 ? $these->[1] / $those->[0] : 9**9**9
    );
}

# The same ratio of their fastest frames: whatever else the machine does only
# adds to a frame's time. And the least and the most that it may be, for the
# rounds disagree, and three frames of four may be that much slower. What a
# point that may be `without` takes is not counted.
sub growth {
    my ( $pass, $point, $other, $without ) = @_;
    my $rest = $without ? min( @{ $without->{fastest}{$pass} } ) : 0;
    my ( $these, $those ) = map {
        my @times = map { $_ - $rest } @{ $_->{fastest}{$pass} },
          $_->{"${pass}_q3"};
        [ min(@times), max(@times) ]
    } $point, $other;
    my ( undef, $growth ) = spread( [ ( $these->[0] ) x 2 ], $those );
    return ( $growth, spread( $these, $those ) );
}

# Whether a ratio lies between two bounds: 1, 0, or undef where that depends
# on the frame, which is a busy machine's doing.
sub lies_between {
    my ( $least, $most, $growth, $from, $to ) = @_;
    return 1 if $growth >= $least && $growth <= $most;
    return   if $to >= $least     && $from <= $most;
    return 0;
}

# What became of a claim, in a word.
sub outcome {
    my ($claim) = @_;
    return
        !defined $claim->{holds} ? 'unclear'
      : $claim->{holds}          ? 'holds'
      :                            'FAILS';
}

# Each: {holds, text}, holds being undef where it cannot be told; of points that
# were not measured, nothing.
sub claims {
    my @points = @_;
    my %point  = map { ( "$_->{scene} $_->{label}" => $_ ) }
      grep { !$_->{missing} } @points;
    my @claims;
    my $claim = sub {
        my ( $holds, $format, @values ) = @_;
        push @claims,
          {
            holds => defined $holds ? ( $holds ? 1 : 0 ) : undef,
            text  => sprintf $format,
            @values
          };
    };
    my $pick = sub {
        my @found = map { $point{$_} } @_;
        return grep( { !$_ } @found ) ? () : @found;
    };
    my $bad = sum0( map { $_->{footprint_nonfinite} // 0 } values %point );
    $claim->( $bad == 0, 'values that are not finite: %d', $bad ) if %point;
    my %scenes = map { $_->{scene} => 1 } @points;
    for my $scene ( sort keys %scenes ) {
        # What PCF adds to hard shadows grows with n^2, 19.6 times: not 4.4
        # times, with n.
        for ( [ 'PCF', 8, 1e9, 'hard' ], [ 'VSM', 0, 1.2 ] ) {
            my ( $name, $least, $most, @without ) = @$_;
            my @found = $pick->(
                map { "$scene $_" } "$name 31", "$name 7", @without
            ) or next;
            my @growth = growth( 'shading', @found );
            $claim->(
                scalar lies_between( $least, $most, @growth ),
                '%s: shading%s, %s 31 over %s 7: %.2f '
                  . '(rounds: %.2f to %.2f)',
                $scene,
                @without ? " without that of @without" : '',
                $name,
                $name,
                @growth
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
