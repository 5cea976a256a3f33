# Turns the tables of Techniques.pm into the points that `make report`
# measures, and the list of what is left out, with reasons.
#
# A technique whose option a program's --help does not name is left out by
# itself, and appears as soon as the program has it.
package Sweep;

use strict;
use warnings;

use Exporter qw(import);
use VSM;
use Techniques qw(%MODES @SCENES $MAP @TECHNIQUES @EXCLUDED $NOT_MEASURED);

our @EXPORT_OK = qw(mode sweep);

# What the soft techniques are compared with, against the same area light.
my @BESIDE_SOFT = ( 'hard', 'PCF 7', 'VSM 7' );

sub mode {
    my ($name) = @_;
    my $mode = $MODES{$name}
      or die "REPORT=$name: one of "
      . join( ', ', sort keys %MODES )
      . " is needed\n";
    return { name => $name, %$mode };
}

# What a step's --help promises: {flag}, the values to choose from. Nothing
# where the program does not answer: then its runs will fail and say why.
my %help;

sub promised {
    my ($step) = @_;
    return $help{$step} //= do {
        my $run = run( $step, '--help' );
        my %flags;
        while ( $run->{out} =~ /^  (--[a-z-]+) (.*)$/mg ) {
            my ( $flag, $choices ) = ( $1, $2 );
            $flags{$flag} = $choices =~ /^\w+(?:,\w+)+$/ ? $choices : '';
        }
        \%flags;
    };
}

# Why the program cannot run with these options: '' where it can.
sub lacks {
    my ( $step, @options ) = @_;
    my $flags = promised($step);
    return '' unless %$flags;
    while (@options) {
        my $flag  = shift @options;
        my $value = @options && $options[0] !~ /^--/ ? shift @options : '';
        return "step $step has no $flag yet" unless exists $flags->{$flag};
        my %choices = map { $_ => 1 } split /,/, $flags->{$flag};
        return "step $step has no $flag $value yet"
          if %choices && !$choices{$value};
    }
    return '';
}

# Whether a mode's list, if it has one, names the value.
sub chosen {
    my ( $list, $value ) = @_;
    return !$list || grep { $_ eq $value } @$list;
}

# {n} is the width in texels of the map, {r} the radius of that width, {d} the
# radius of about the same width after downsampling by 2, {l} the light's size.
sub filled {
    my ( $template, $width, $scene ) = @_;
    my %value = (
        l => $scene->{light_size} // 1,
        n => $width,
        r => ( $width - 1 ) / 2,
        d => ( $width - 3 ) / 4,
    );
    return split / /, $template =~ s/\{(\w)\}/$value{$1}/gr;
}

# "VSM 7", "VSM 7, map 1024": a point among those of its scene.
sub label {
    my ($point) = @_;
    my $name = $point->{technique};
    $name .= " $point->{width}"    if $point->{width} > 1;
    $name .= ", map $point->{map}" if $point->{map} != $point->{usual_map};
    return $name;
}

sub point {
    my ( $mode, $technique, $scene, $width, $map ) = @_;
    my $usual = $mode->{map} // $scene->{map} // $MAP;
    my %point = (
        scene     => $scene->{name},
        technique => $technique->{name},
        family    => $technique->{family},
        step      => $technique->{step},
        width     => $width,
        map       => $map || $usual,
        usual_map => $usual,
        rays      => $mode->{rays},
    );
    $point{options} = [
        '--scene',
        $scene->{option} // $scene->{name},
        '--size',
        $mode->{size},
        '--map-size',
        $point{map},
        filled( $technique->{options}, $width, $scene ),
    ];
    $point{label}      = label( \%point );
    $point{soft}       = $technique->{soft};
    $point{light_size} = $scene->{light_size}
      if $point{soft} || grep { $_ eq $point{label} } @BESIDE_SOFT;
    $point{pictured} = grep { $_ eq $point{label} } @{ $scene->{pictures} };
    return \%point;
}

# The points of one technique on one scene: its widths on the usual map, and
# where the scene's size of the map is varied, on the other maps.
sub points_of {
    my ( $mode, $technique, $scene ) = @_;
    my @widths =
      grep { chosen( $mode->{widths}, $_ ) } @{ $technique->{widths} };
    my @points = map { point( $mode, $technique, $scene, $_ ) } @widths;
    return @points if $mode->{why};    # not of the full report
    my $maps = $technique->{maps}{ $scene->{name} } // {};
    for my $map ( sort { $a <=> $b } keys %$maps ) {
        push @points,
          map { point( $mode, $technique, $scene, $_, $map ) }
          @{ $maps->{$map} };
    }
    return @points;
}

# The points of a mode, scene by scene, and what is left out: {what, scenes,
# reason} each.
sub sweep {
    my ($mode) = @_;
    my ( @points, %left_out );
    for my $scene (@SCENES) {
        next unless chosen( $mode->{scenes}, $scene->{name} );
        for my $technique (@TECHNIQUES) {
            my ( $name, $step, $options ) = @$technique{qw(name step options)};
            next unless chosen( $mode->{techniques}, $name );
            my $reason = lacks( $step, filled( $options, 3, $scene ) );
            $reason ||= $technique->{why}
              unless chosen( $technique->{scenes}, $scene->{name} );
            if ($reason) {
                push @{ $left_out{$reason}{$name} }, $scene->{name};
                next;
            }
            for my $point ( points_of( $mode, $technique, $scene ) ) {
                my ($rule) = grep { $_->[1]->($point) } @EXCLUDED;
                push @points, $point unless $rule;
                push @{ $left_out{ $rule->[0] }{ $point->{label} } },
                  $scene->{name}
                  if $rule;
            }
        }
    }
    return ( \@points, left_out( $mode, \%left_out ) );
}

sub left_out {
    my ( $mode, $found ) = @_;
    my @list;
    for my $reason ( sort keys %$found ) {
        for my $what ( sort keys %{ $found->{$reason} } ) {
            push @list,
              {
                what   => $what,
                scenes => $found->{$reason}{$what},
                reason => $reason,
              };
        }
    }
    my @more = @$NOT_MEASURED;
    unshift @more,
      [
        'every other scene, technique and width',
        "REPORT=$mode->{name} $mode->{why}"
      ]
      if $mode->{why};
    push @list,
      map { { what => $_->[0], scenes => [], reason => $_->[1] } } @more;
    return \@list;
}

1;
