# Puts out/report/index.html together: page.html with page.css, page.js and
# what was measured. One file, without anything from elsewhere.
package Page;

use strict;
use warnings;

use Exporter qw(import);
use FindBin;
use VSM;
use Columns qw(@COLUMNS @CHAIN);
use Judge   qw(outcome);
use Plot    qw(work_precision growth stair);
use Verdict qw(verdict);

our @EXPORT_OK = qw(page);

sub escaped {
    my ($text) = @_;
    my %entity =
      ( '&' => '&amp;', '<' => '&lt;', '>' => '&gt;', '"' => '&quot;' );
    return $text =~ s/([&<>"])/$entity{$1}/gr;
}

# Three significant digits, without an exponent where that is short.
sub number {
    my ($value) = @_;
    return ''         if !defined $value || $value eq '';
    return $value + 0 if $value == 0;
    return sprintf '%.1e', $value if abs $value < 1e-3;
    my $digits = 2 - int( log( abs $value ) / log(10) + 100 ) + 100;
    return sprintf '%.*f', $digits > 0 ? $digits : 0, $value;
}

# The different values of a column, in the points' order.
sub names_of {
    my ( $column, @points ) = @_;
    my %seen;
    return grep { !$seen{$_}++ } map { $_->{$column} } @points;
}

# --- diagrams ----------------------------------------------------------------

# Why diagrams could not be drawn, of the page that is being made.
my @undrawn;

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
sub maps {
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

# --- the table ---------------------------------------------------------------

my @TABLE = (
    [ 'scene',           'Scene' ],
    [ 'label',           'Technique' ],
    [ 'total_ms',        'Frame, ms' ],
    [ 'spread',          'Quartiles' ],
    [ 'map_ms',          'Map' ],
    [ 'blur_ms',         'Blur' ],
    [ 'shading_ms',      'Shading' ],
    [ 'mib',             'Maps, MiB' ],
    [ 'footprint_rmse',  'RMSE' ],
    [ 'footprint_p99',   '99 %' ],
    [ 'footprint_max',   'Largest' ],
    [ 'footprint_share', 'Over 1/255' ],
    [ 'pcf_rmse',        'RMSE, same weights' ],
    [ 'light_rmse',      'RMSE, light' ],
    [ 'butteraugli',     'Seen' ],
    [ 'front',           'Front' ],
);

sub cell {
    my ( $point, $column ) = @_;
    my $value = $point->{$column} // '';
    if ( $column eq 'spread' && defined $point->{total_q1} ) {
        return sprintf '<td data-value="%s">%s&ndash;%s</td>',
          $point->{total_q3} - $point->{total_q1},
          map { number($_) } @$point{qw(total_q1 total_q3)};
    }
    $value = $point->{map_bytes} / 2**20
      if $column eq 'mib' && $point->{map_bytes};
    return sprintf '<td data-value="%d">%s</td>', $value || 0,
      $value ? '*' : ''
      if $column eq 'front';
    return '<td>' . escaped($value) . '</td>'
      if $column eq 'scene' || $column eq 'label';
    return '<td></td>' if $value eq '';
    return sprintf '<td data-value="%s">%s</td>', $value, number($value);
}

sub table_rows {
    my $text = '';
    for my $point (@_) {
        my $title =
          escaped( "step $point->{step}: @{ $point->{options} }"
              . ( $point->{missing} ? "; $point->{missing}" : '' ) );
        $text .=
            "<tr title=\"$title\">"
          . join( '', map { cell( $point, $_->[0] ) } @TABLE )
          . "</tr>\n";
    }
    return $text;
}

sub table_head {
    return join '',
      map { "<th scope=\"col\"><button type=\"button\">$_->[1]</button></th>" }
      @TABLE;
}

# --- the rest ----------------------------------------------------------------

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

sub missing_list {
    my @missing = grep { $_->{missing} } @_ or return '';
    my %by_reason;
    push @{ $by_reason{ $_->{missing} } }, "$_->{scene} $_->{label}"
      for @missing;
    return
        '<div class="missing"><p><b>'
      . scalar @missing
      . " points are not complete:</b></p>\n<ul>\n"
      . join(
        '',
        map {
                '<li>'
              . escaped( join( ', ', @{ $by_reason{$_} } ) . ": $_" )
              . "</li>\n"
        } sort keys %by_reason
      ) . "</ul></div>\n";
}

sub left_out_list {
    my $text = '';
    for my $entry (@_) {
        my $where =
          @{ $entry->{scenes} }
          ? ' on ' . join( ', ', @{ $entry->{scenes} } )
          : '';
        $text .=
            '<li>'
          . escaped("$entry->{what}$where: $entry->{reason}")
          . "</li>\n";
    }
    return $text;
}

sub pairs_list {
    my @pairs = @_;
    my $text  = '';
    while ( my ( $name, $meaning ) = splice @pairs, 0, 2 ) {
        $text .=
          '<dt>' . escaped($name) . '</dt><dd>' . escaped($meaning) . "</dd>\n";
    }
    return $text;
}

my @ENVIRONMENT = (
    [ cpu         => 'Processor' ],
    [ cores       => 'Cores' ],
    [ system      => 'System' ],
    [ gl_renderer => 'Renderer' ],
    [ gl_version  => 'Driver' ],
    [ clock       => 'Clock' ],
    [ picture     => 'Picture' ],
    [ rays        => 'Rays of an average' ],
    [ mode        => 'Report' ],
    [ commit      => 'Commit' ],
    [ date        => 'Date' ],
);

sub filled {
    my ( $template, %value ) = @_;
    return $template =~ s/\{\{(\w+)\}\}/$value{$1} \/\/ die "no $1\n"/ger;
}

# The whole page, and the problems in making it. report: points, environment,
# left_out, claims.
sub page {
    my ( $folder, %report ) = @_;
    my @points = @{ $report{points} };
    my $about  = $report{environment};
    my @scenes = names_of( 'scene', @points );
    my $here   = $FindBin::Bin;
    @undrawn = ();
    my $page = filled(
        slurp("$here/page.html"),
        css    => slurp("$here/page.css"),
        js     => slurp("$here/page.js"),
        counts =>
          sprintf( '%d points on %d scenes.', scalar @points, scalar @scenes ),
        machine => escaped(
                "$about->{cpu}, $about->{cores} cores, $about->{gl_renderer}; "
              . "pictures of $about->{picture}; $about->{date}"
        ),
        missing => missing_list(@points),
        clock   => escaped( $about->{clock} ),
        links   => join( ' ',
            map( { "<a href=\"#scene-$_\">$_</a>" } @scenes ),
            '<a href="#table">all points</a>' ),
        scenes => join(
            '',
            map {
                my $scene = $_;
                scene_section( $folder, $scene,
                    grep { $_->{scene} eq $scene } @points )
            } @scenes
        ),
        maps    => maps( $folder, @points ),
        options => join( '', map { "<option>$_</option>" } @scenes ),
        head    => table_head(),
        rows    => table_rows(@points),
        claims  => join(
            '',
            map {
                sprintf "<li class=\"%s\">%s: %s</li>\n",
                  lc outcome($_), outcome($_),
                  escaped( $_->{text} )
            } @{ $report{claims} }
        ),
        left_out    => left_out_list( @{ $report{left_out} } ),
        environment =>
          pairs_list( map { ( $_->[1] => $about->{ $_->[0] } ) } @ENVIRONMENT ),
        column_count => scalar @COLUMNS,
        columns      => pairs_list( map { @$_ } @COLUMNS ),
    );
    return ( $page, @undrawn );
}

1;
