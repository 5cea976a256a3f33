# Puts out/report/index.html together: page.html with page.css, page.js and
# what was measured. One file, without anything from elsewhere.
package Page;

use strict;
use warnings;

use Exporter qw(import);
use FindBin;
use VSM;
use Columns qw(@COLUMNS);
use Html    qw(escaped number names_of);
use Judge   qw(busy outcome);
use Scene   qw(scene_section maps_section undrawn);
use Verdict qw(compared in_short);

our @EXPORT_OK = qw(page);

# --- in short ----------------------------------------------------------------

# VSM beside PCF, a row for each scene: {from}, then a column for each of these.
my @SHORT = (
    [ faster  => 15, 'Times as fast at 15' ],
    [ faster  => 31, 'at 31' ],
    [ wronger => 7,  'Times as wrong at 7' ],
    [ wronger => 15, 'at 15' ],
    [ wronger => 31, 'at 31' ],
);

sub short_row {
    my ( $name, $compared ) = @_;
    my @numbers = map {
        my ( $what, $width ) = @$_;
        number( $compared->{$what}{$width}, 2 )
    } @SHORT;
    return "<tr><td><a href=\"#scene-$name\">$name</a></td>"
      . join( '', map { "<td>$_</td>" } $compared->{from} // '&ndash;',
        @numbers )
      . '<td>'
      . (
        defined $compared->{useless}
        ? "<strong>do not use VSM $compared->{useless}</strong>"
        : ''
      ) . "</td></tr>\n";
}

# From [name, what was compared] of each scene.
sub short_section {
    my @scenes = @_ or return '<p>PCF and VSM were not both measured.</p>';
    my @heads =
      ( 'Scene', 'VSM is faster from width', map( { $_->[2] } @SHORT ), '' );
    my @sentences = map { escaped($_) } in_short(@scenes);
    s{^(Do not .*)}{<strong>$1</strong>} for @sentences;
    return
        '<p class="verdict">'
      . join( ' ', @sentences )
      . "</p>\n<div class=\"wide\">\n<table id=\"short\">\n<thead><tr>"
      . join( '', map { "<th scope=\"col\">$_</th>" } @heads )
      . "</tr></thead>\n<tbody>\n"
      . join( '', map { short_row(@$_) } @scenes )
      . "</tbody>\n</table>\n</div>\n";
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

# An edge crosses as many of the strata as they are along a side, and the share
# of each is then a ray's, 0 or 1: a variance of up to 1/4.
sub noise {
    my ($rays) = @_;
    return sqrt( sqrt($rays) / 4 ) / $rays;
}

# The whole page, and the problems in making it. report: points, environment,
# left_out, claims.
sub page {
    my ( $folder, %report ) = @_;
    my @points   = @{ $report{points} };
    my $about    = $report{environment};
    my @scenes   = names_of( 'scene', @points );
    my $here     = $FindBin::Bin;
    my @compared = map {
        my $scene = $_;
        my $pair  = compared( grep { $_->{scene} eq $scene } @points );
        $pair ? [ $scene, $pair ] : ()
    } @scenes;
    undrawn();    # of an earlier page
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
        rays    => $about->{rays},
        noise   => number( noise( $about->{rays} ), 2 ),
        missing => missing_list(@points),
        busy    => busy(@points),
        short   => short_section(@compared),
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
        maps    => maps_section( $folder, @points ),
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
    return ( $page, undrawn() );
}

1;
