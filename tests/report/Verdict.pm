# What the points of a scene say, in plain words, and only what they say.
package Verdict;

use strict;
use warnings;

use Exporter qw(import);
use Judge    qw(ratio);

our @EXPORT_OK = qw(verdict crossing compared in_short);

# Of PCF and plain VSM at the same widths: how much longer PCF takes, frame by
# frame of the same round.
sub pairs {
    my %point = map { ( $_->{label} => $_ ) } @_;
    my @pairs;
    for my $width ( 3, 7, 15, 31 ) {
        my ( $pcf, $vsm ) = @point{ "PCF $width", "VSM $width" };
        next unless $pcf            && $vsm;
        next unless $pcf->{medians} && $vsm->{medians};
        push @pairs,
          {
            width  => $width,
            factor => ratio( 'total', $pcf, $vsm ),
            pcf    => $pcf,
            vsm    => $vsm,
          };
    }
    return @pairs;
}

# The width from which on the factor stays above 1, between the measured ones
# along a straight line of logarithms; 0: at all of them, undef: not at the
# widest.
sub crossing {
    my @pairs = @_;
    return if !@pairs || $pairs[-1]{factor} <= 1;
    my $below;
    for ( 0 .. $#pairs ) { $below = $_ if $pairs[$_]{factor} <= 1 }
    return 0 unless defined $below;
    my ( $from, $to ) = @pairs[ $below, $below + 1 ];
    my $part = log( $from->{factor} ) / log( $from->{factor} / $to->{factor} );
    return
      exp(
        log( $from->{width} ) + $part * log( $to->{width} / $from->{width} ) );
}

# Odd, as widths are, and not below.
sub next_width {
    my ($width) = @_;
    my $whole = int $width;
    $whole++ while $whole < $width || $whole % 2 == 0;
    return $whole;
}

sub factor {
    my ($factor) = @_;
    return sprintf $factor < 9.95 ? '%.1f' : '%.0f', $factor;
}

sub enumerated {
    my @items = @_;
    my $last  = pop @items;
    return @items ? join( ', ', @items ) . " and $last" : $last;
}

# Who is faster, and from which width on.
sub overtaking {
    my @pairs    = @_;
    my $crossing = crossing(@pairs);
    my ($first)  = map { $_->{width} } @pairs;
    return "VSM is faster than PCF at every width measured, from $first on"
      if defined $crossing && $crossing == 0;
    my @before =
      map { $_->{width} }
      grep { $_->{factor} > 1 && $_->{width} < ( $crossing // 1e9 ) } @pairs;
    my $named = @before ? enumerated(@before) : '';
    if ( !defined $crossing ) {
        return 'PCF is faster than VSM at every width measured' if !@before;
        return 'VSM does not overtake PCF for good: it is faster only at '
          . $named;
    }
    my $but = @before ? " (but for $named)" : '';
    return
        'PCF is faster below width '
      . next_width($crossing)
      . "$but, VSM from there on";
}

sub faster {
    my @pairs = @_;
    my @named = grep { $_->{width} == 15 || $_->{width} == 31 } @pairs;
    @named = ( $pairs[-1] ) unless @named;
    my $numbers = join ', ', map {
        my ( $who, $by ) =
          $_->{factor} >= 1
          ? ( 'VSM', $_->{factor} )
          : ( 'PCF', 1 / $_->{factor} );
        "at $_->{width} $who is " . factor($by) . ' times as fast'
    } @named;
    return overtaking(@pairs) . "; $numbers.";
}

# The links of a point's chain between footprint truth and the program.
my %BLAME = (
    pcf       => 'the map\'s texels',
    chebyshev => 'light bleeding',
    floor     => 'the minimum variance',
    reduction => 'the light-bleeding reduction',
    format    => 'the number format',
    program   => 'its lookup and its rasteriser',
);

# Those that change the visibility most: the largest, and what is at least half
# as large.
sub blamed {
    my ($point) = @_;
    my %rmse    = map  { $_ => $point->{"chain_${_}_rmse"} || 0 } keys %BLAME;
    my @links   = sort { $rmse{$b} <=> $rmse{$a} || $a cmp $b } keys %rmse;
    my $most    = $rmse{ $links[0] };
    return '' if $most < 1e-3;
    return enumerated(
        map  { $BLAME{$_} }
        grep { $rmse{$_} >= $most / 2 } @links
    );
}

# How wrong VSM is beside PCF, each against the exact average over its filter.
sub wronger {
    my @pairs  = @_;
    my @judged = grep {
             defined $_->{pcf}{footprint_rmse}
          && defined $_->{vsm}{footprint_rmse}
    } @pairs;
    return '' unless @judged;
    my ($pair) = grep { $_->{width} == 7 } @judged;
    $pair //= $judged[0];
    my ( $pcf, $vsm ) = map { $pair->{$_}{footprint_rmse} } qw(pcf vsm);
    return '' unless $pcf > 0 && $vsm > 0;
    my $numbers = sprintf 'RMSE %.4f against %.4f', $vsm, $pcf;
    my $ratio   = $vsm / $pcf;
    return "At width $pair->{width} VSM is as near to its footprint as PCF "
      . "($numbers)."
      if $ratio > 0.9 && $ratio < 1.1;
    my $text =
      $ratio < 1
      ? 'nearer to its footprint than PCF'
      : factor($ratio) . ' times as wrong as PCF';
    my $why = $ratio > 1 ? blamed( $pair->{vsm} ) : '';
    return
      "At width $pair->{width} VSM is $text ($numbers"
      . ( $why ? "; it comes from $why" : '' ) . ').';
}

# What the light-bleeding reduction does to it.
sub reduced {
    my %point = map { ( $_->{label} => $_ ) } @_;
    my @changes;
    for my $width ( 7, 31 ) {
        my ( $without, $with ) =
          map { $point{"$_ $width"}{footprint_rmse} } 'VSM', 'VSM reduced';
        push @changes, sprintf 'from %.4f to %.4f at %d', $without, $with,
          $width
          if defined $without && defined $with;
    }
    return @changes
      ? 'The light-bleeding reduction takes VSM\'s RMSE '
      . enumerated(@changes) . '.'
      : '';
}

# The width from which on even the best of VSM is more than twice as wrong as
# PCF, and no nearer to the truth than hard shadows are: nothing speaks for it
# there. Undef where that is not so at the widest.
sub useless_from {
    my ( $points, @pairs ) = @_;
    my %point = map { ( $_->{label} => $_ ) } @$points;
    my $hard  = $point{hard}{footprint_rmse} // return;
    my $from;
    for my $pair ( reverse @pairs ) {
        my ($best) = sort { $a <=> $b }
          map { $point{"$_ $pair->{width}"}{footprint_rmse} // () } 'VSM',
          'VSM reduced';
        my $pcf = $pair->{pcf}{footprint_rmse};
        last unless defined $best && defined $pcf;
        last if $best <= 2 * $pcf || $best <= $hard;
        $from = $pair->{width};
    }
    return $from;
}

# "from width 15 on"; nothing where that is all of them.
sub from_on {
    my ( $from, $narrowest ) = @_;
    return $from > $narrowest ? "from width $from on" : '';
}

sub advice {
    my ( $scene, $points, @pairs ) = @_;
    my $from  = useless_from( $points, @pairs ) // return '';
    my $where = from_on( $from, $pairs[0]{width} );
    return
        join( ' ', "Do not use VSM on $scene", $where || () )
      . ': it is more than twice as wrong as PCF there, and no nearer to the '
      . 'truth than hard shadows.';
}

# The techniques that imitate a light with an area, beside some that do not.
sub soft {
    my %point = map  { ( $_->{label} => $_ ) } @_;
    my @soft  = grep { defined $point{$_}{area_rmse} } 'soft', 'soft hybrid';
    return '' unless @soft;
    my @other =
      grep { defined $point{$_}{area_rmse} } 'hard', 'PCF 7', 'VSM 7';
    return
        'Against an area light of size '
      . "$point{ $soft[0] }{light_size}, RMSE: "
      . join( ', ',
        map { sprintf '%s %.4f', $_, $point{$_}{area_rmse} } @soft, @other )
      . '.';
}

# A scene's points as numbers: {from}, the width from which on VSM is faster
# than PCF, undef where it is not at the {widest}; by width {faster}, how many
# times as fast it is, and {wronger}, how many times as wrong; {useless}, where
# it is not to be used, in words. Nothing where not both were measured.
sub compared {
    my @points   = @_;
    my @pairs    = pairs(@points) or return;
    my $crossing = crossing(@pairs);
    my $useless  = useless_from( \@points, @pairs );
    my %wronger;
    for my $pair (@pairs) {
        my ( $pcf, $vsm ) = map { $pair->{$_}{footprint_rmse} } qw(pcf vsm);
        $wronger{ $pair->{width} } = $vsm / $pcf if defined $vsm && $pcf;
    }
    return {
          from => !defined $crossing ? undef
        : $crossing ? next_width($crossing)
        : $pairs[0]{width},
        widest  => $pairs[-1]{width},
        faster  => { map { $_->{width} => $_->{factor} } @pairs },
        wronger => \%wronger,
        useless => defined $useless ? from_on( $useless, $pairs[0]{width} )
        : undef,
    };
}

sub from_to {
    my @words = @_;
    return $words[0] eq $words[-1] ? $words[0] : "$words[0] to $words[-1]";
}

# What the scenes say together: [name, what was compared] each.
sub in_short {
    my @scenes = @_ or return;
    my @from   = sort { $a <=> $b } map { $_->[1]{from} // () } @scenes;
    my @never  = map  { defined $_->[1]{from} ? () : $_->[0] } @scenes;
    my @bad    = map {
        my ( $name, $compared ) = @$_;
        my $where = $compared->{useless};
        defined $where ? $name . ( $where && " ($where)" ) : ()
    } @scenes;
    my @faster = map {
        my $width = $_;
        my @factors =
          sort { $a <=> $b } map { $_->[1]{faster}{$width} // () } @scenes;
        @factors
          ? from_to( map { factor($_) } @factors ) . " times as fast at $width"
          : ()
    } 15, 31;
    return (
        @from ? 'VSM overtakes PCF at width ' . from_to(@from) . '.' : (),
        @never
        ? 'It does not on '
          . enumerated(@never)
          . ", up to $scenes[0][1]{widest}."
        : (),
        @faster ? 'It is ' . enumerated(@faster) . '.'          : (),
        @bad    ? 'Do not use VSM on ' . enumerated(@bad) . '.' : (),
    );
}

# Sentences about a scene's points.
sub verdict {
    my ( $scene, @points ) = @_;
    my @pairs = pairs(@points);
    return ('PCF and VSM were not both measured here.') unless @pairs;
    return grep { $_ ne '' } faster(@pairs), wronger(@pairs),
      reduced(@points), soft(@points), advice( $scene, \@points, @pairs );
}

1;
