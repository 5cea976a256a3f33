# A scene's section of the page: the verdict, diagrams, where the error comes
# from, pictures.
package Scene;

use strict;
use warnings;

use Exporter qw(import);
use Columns  qw(@CHAIN);
use Html     qw(escaped number names_of);
use Plot     qw(work_precision growth stair);
use Verdict  qw(verdict);

our @EXPORT_OK = qw(scene_section maps_section undrawn);

# --- diagrams ----------------------------------------------------------------

# Why diagrams could not be drawn.
my @undrawn;

# Those since the last call.
sub undrawn { return splice @undrawn }

sub figure {
    my ( $caption, $svg, $why ) = @_;
    push @undrawn, "diagram '$caption': $why" if !defined $svg && $why;
    my $drawing = $svg
      // '<p class="missing">No diagram: ' . escaped( $why // '' ) . '</p>';
    return "<figure>\n$drawing\n<figcaption><small>$caption</small>"
      . "</figcaption>\n</figure>\n";
}

# The techniques of a scene that were measured at several widths.
sub by_width {
    my %lines;
    for my $point (@_) {
        next if $point->{map} != $point->{usual_map} || $point->{width} == 1;
        push @{ $lines{ $point->{technique} } }, $point;
    }
    my %few =
      map { $_ => 1 } (
        'PCF',
        'PCF Poisson',
        'VSM',
        'VSM Gaussian',
        'VSM boxes',
        'VSM by fragments',
        'VSM downsampled',
        'SAT'
      );
    return map { $few{$_} ? ( $_ => $lines{$_} ) : () } keys %lines;
}

# Who is on the front of a diagram, from the fastest on.
sub front {
    my ( $truth, @points ) = @_;
    my @names = map { escaped( $_->{label} ) } stair( $truth, @points );
    return @names ? '. Front: ' . join( ' &middot; ', @names ) : '';
}

# A comparison with the mean is so wrong that the others would be a heap beside
# it; maps of other sizes have their own section.
sub diagrams {
    my ( $folder, $scene, @points ) = @_;
    my @shown = grep { $_->{map} == $_->{usual_map} } @points;
    my @area  = grep { defined $_->{area_rmse} } @shown;
    my @drawn = grep { $_->{family} ne 'mean' } @shown;
    my $without =
      @drawn < @shown ? '. Not drawn: compared mean, far above' : '';
    return "<div class=\"grid\">\n"
      . figure(
        'Error against time' . $without . front( 'footprint', @drawn ),
        work_precision( $folder, $scene, 'footprint', @drawn )
      )
      . figure(
        'Time against the filter\'s width; bars are quartiles',
        growth( $folder, $scene, 'width', 'width, texels', by_width(@points) )
      )
      . (
        !( grep { $_->{soft} } @area ) ? '' : figure(
            'Error against an area light, against time'
              . front( 'area', @area ),
            work_precision( $folder, $scene, 'area', @area )
        )
      ) . "</div>\n";
}

# The points of a scene at width 7, or without a width, by technique: those
# measured with maps of several sizes.
sub by_map {
    my %lines;
    for my $point (@_) {
        next unless $point->{width} == 1 || $point->{width} == 7;
        push @{ $lines{ $point->{technique} } }, $point;
    }
    return map { @{ $lines{$_} } > 1 ? ( $_ => $lines{$_} ) : () } keys %lines;
}

# Where a scene was measured with maps of several sizes.
sub maps_section {
    my ( $folder, @points ) = @_;
    my $text = '';
    for my $scene ( names_of( 'scene', @points ) ) {
        my @own = grep { $_->{scene} eq $scene } @points;
        next if names_of( 'map', @own ) < 2;
        my %lines = by_map(@own);
        my @drawn = grep { $_->{family} ne 'mean' } @own;
        $text .= figure(
            "$scene, maps of all sizes: error against time"
              . front( 'footprint', @drawn ),
            work_precision( $folder, "$scene-maps", 'footprint', @drawn )
        );
        $text .= figure(
            "$scene, width 7: time against the map's size",
            growth(
                $folder, "$scene-map",
                'map',   'side of the map, texels',
                %lines
            )
        ) if %lines;
    }
    return $text ne ''
      ? "<div class=\"grid\">\n$text</div>"
      : '<p>Measured with one size of map only.</p>';
}

# --- the error's chain -------------------------------------------------------

sub bars {
    my ( $point, $longest ) = @_;
    my $text =
        "<div class=\"chain\">\n<h4>"
      . escaped( $point->{label} )
      . "</h4>\n<ol>\n";
    for (@CHAIN) {
        my ( $link, $meaning ) = @$_;
        my $rmse = $point->{"chain_${link}_rmse"};
        next unless defined $rmse && $rmse ne '';
        my $mean = $point->{"chain_${link}_mean"};
        $text .= sprintf "<li title=\"%s\"><span>%s</span>"
          . "<i style=\"width:%.1f%%\"></i><span>%s (%s%s)</span></li>\n",
          escaped($meaning), $link, 100 * $rmse / $longest, number($rmse),
          $mean < 0 ? '&minus;' : '+', number( abs $mean );
    }
    return "$text</ol>\n</div>\n";
}

sub chains {
    my @points = grep { defined $_->{chain_program_rmse} } @_;
    my @wanted = ( 'hard', 'PCF 7', 'VSM 7', 'VSM reduced 7', 'VSM 31' );
    my %point  = map  { ( $_->{label} => $_ ) } @points;
    my @chosen = grep { $_ } @point{@wanted} or return '';
    my ($most) = sort { $b <=> $a }
      map {
        my $point = $_;
        map { $point->{"chain_$_->[0]_rmse"} || 0 } @CHAIN
      } @chosen;
    return
        "<h3>Where the error comes from</h3>\n<p class=\"fine\">What each "
      . 'substitution between light truth and the program changes: RMSE, and '
      . "in brackets the mean (&minus; is darker). The signed differences of "
      . "a pixel add up to the program minus light truth.</p>\n"
      . "<div class=\"grid small\">\n"
      . join( '', map { bars( $_, $most || 1 ) } @chosen )
      . "</div>\n";
}

# --- pictures ----------------------------------------------------------------

sub image {
    my ( $point, $which, $class, $what ) = @_;
    my $name = escaped("$point->{scene}, $point->{label}");
    return "<img$class alt=\"$what of $name\" "
      . "src=\"data:image/png;base64,$point->{pictures}{$which}\">";
}

sub card {
    my ($point) = @_;
    my $name    = escaped( $point->{label} );
    my $truth   = $point->{soft} ? 'area light' : 'footprint truth';
    my $rmse    = number( $point->{footprint_rmse} // $point->{light_rmse} );
    return
        "<figure class=\"card\">\n<figcaption><b>$name</b> "
      . "<small>RMSE $rmse</small></figcaption>\n<div class=\"compare\">"
      . image( $point, 'truth',  '',                $truth )
      . image( $point, 'result', ' class="result"', 'result' )
      . "</div>\n<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
      . "aria-label=\"$name: $truth left of here, result right\">\n"
      . "<div class=\"ends\"><small>$truth</small><small>result</small></div>\n"
      . image( $point, 'difference', '', 'signed difference' )
      . "<div class=\"legend\"></div>\n<div class=\"ends\"><small>1 too dark"
      . "</small><small>0</small><small>1 too light</small></div>\n</figure>\n";
}

sub pictures {
    my @shown = grep { $_->{pictures} } @_ or return '';
    return
        "<h3>Visibility, and its signed difference to the truth</h3>\n"
      . "<div class=\"grid\">\n"
      . join( '', map { card($_) } @shown )
      . "</div>\n";
}

sub scene_section {
    my ( $folder, $scene, @points ) = @_;
    my @sentences = map { escaped($_) } verdict( $scene, @points );
    s{^(Do not .*)}{<strong>$1</strong>} for @sentences;
    return
        "<section id=\"scene-$scene\">\n<h2>$scene</h2>\n"
      . '<p class="verdict">'
      . join( ' ', @sentences )
      . "</p>\n"
      . diagrams( $folder, $scene, @points )
      . chains(@points)
      . pictures(@points)
      . "</section>\n";
}

1;
