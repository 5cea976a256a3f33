# The page's diagrams: gnuplot's SVG, without what would clash with the page.
package Plot;

use strict;
use warnings;

use Exporter qw(import);
use VSM;

our @EXPORT_OK = qw(work_precision growth stair);

# Readable on white and on black.
my %COLOUR = (
    hard          => '#888888',
    PCF           => '#e07b00',
    VSM           => '#2f7ed8',
    'VSM reduced' => '#8e5bd0',
    SAT           => '#2aa876',
    'VSM rounded' => '#d0498b',
    soft          => '#c0392b',
    mean          => '#a89400',
);
my %MARK = (
    hard          => 5,
    PCF           => 7,
    VSM           => 9,
    'VSM reduced' => 11,
    SAT           => 13,
    'VSM rounded' => 8,
    soft          => 4,
    mean          => 2,
);
my @FAMILIES = (
    'hard', 'PCF',         'VSM',  'VSM reduced',
    'SAT',  'VSM rounded', 'soft', 'mean'
);

# On a phone the diagram is two thirds of this size.
my $HEAD = <<'END';
set terminal svg size 540,500 dynamic noenhanced font 'sans-serif,16'
set logscale xy
set border 3
set tics nomirror
set grid lc rgb '#808080' lw 0.5 dt 3
set key tmargin center horizontal maxcols 3 samplen 1.5 width 1
END

# What a diagram's errors are against.
my %AXIS = (
    footprint => 'RMSE against footprint truth',
    area      => 'RMSE against the area light',
);

# Runs a script; the SVG as a part of an HTML page, or why there is none. Black
# becomes the page's own colour, and names are made this diagram's.
sub drawn {
    my ( $name, $folder, $script ) = @_;
    my $file = "$folder/$name.gp";
    spew( $file, $script );
    my $run = command( '/usr/bin/env', 'gnuplot', $file );
    unlink $file;
    if ( $run->{status} || $run->{out} !~ /<svg/ ) {
        my ($line) = $run->{err} =~ /([^\n]+)\n*\z/;
        return ( undef, 'gnuplot: ' . ( $line // 'no word why' ) );
    }
    local $_ = $run->{out} =~ s/.*?(?=<svg)//sr;
    s/ color="(?:black|white|gray)"//g;
    s/(fill|stroke)=(["'])black\g2/$1="currentColor"/g;
    s{<title>[^<]*</title>}{}g;
    s{<desc>[^<]*</desc>}{}g;
    s/gp(?=Pt\d|Dot)/$name-gp/g;
    s/(id=["'])(?=gnuplot|textbox|greybox)/$1$name-/g;
    s/[ \t]+$//mg;
    s/\n\n+/\n/g;
    return $_;
}

# Of a logarithmic axis around values.
sub range {
    my @values = sort { $a <=> $b } @_;
    return ( $values[0] / 1.5, $values[-1] * 1.5 );
}

# Such an axis, with a tic at 1, 2 and 5 of
# each decade; gnuplot's own would go to the next power of ten.
sub axis {
    my ( $name, @values ) = @_;
    my ( $low,  $high )   = range(@values);
    my @tics;
    for my $decade ( -9 .. 6 ) {
        push @tics, grep { $_ >= $low && $_ <= $high }
          map { $_ * 10**$decade } 1, 2, 5;
    }
    @tics = grep { sprintf( '%e', $_ ) =~ /^1/ } @tics if @tics > 9;
    return
      "set ${name}range [$low:$high]\nset ${name}tics ("
      . join( ', ', map { sprintf '%g', $_ } @tics ) . ")\n";
}

# One with a tic at each of the values.
sub axis_at {
    my ( $name, @values ) = @_;
    my ( $low,  $high )   = range(@values);
    my %tics = map { $_ => 1 } @values;
    return
      "set ${name}range [$low:$high]\nset ${name}tics ("
      . join( ', ', sort { $a <=> $b } keys %tics ) . ")\n";
}

sub quoted { return "'" . $_[0] =~ s/'/''/gr . "'" }

# One series of gnuplot: its data block, and its part of the plot command.
sub series {
    my ( $index, $style, $title, @rows ) = @_;
    my $block = "\$S$index << EOD\n" . join( "\n", @rows ) . "\nEOD\n";
    my $name  = defined $title ? 'title ' . quoted($title) : 'notitle';
    return ( $block, "\$S$index using $style $name" );
}

# Points of a scene: error against time, the error being that against one of
# the truths. The widths of a family's plain technique are joined, PCF's and
# VSM's named too; beside an area light each point is. The front is a stair
# below them.
sub work_precision {
    my ( $folder, $scene, $truth, @points ) = @_;
    my ( @blocks, @parts );
    my $add = sub {
        my ( $style, $title, @shown ) = @_;
        my ( $block, $part ) = series( scalar @parts,
            $style, $title, map { row( $truth, $_ ) } @shown );
        push @blocks, $block;
        push @parts,  $part;
    };
    @points = judged( $truth, @points );
    return ( '<p>Nothing is measured.</p>', '' ) unless @points;
    $add->(
        '1:2 with steps lw 6 lc rgb "#30808080"',
        'Pareto front', stair( $truth, @points )
    );
    for my $family (@FAMILIES) {
        my @own    = grep { $_->{family} eq $family } @points or next;
        my $colour = "rgb '$COLOUR{$family}'";
        $add->(
            "1:2 with points pt $MARK{$family} ps 0.8 lc $colour",
            $family, @own
        );
        my @named = @own;
        if ( $truth eq 'footprint' ) {
            @named = grep { $_->{label} =~ /^\Q$family\E(?: \d+)?$/ } @own;
            next if @named < 2;
            $add->( "1:2 with lines lc $colour", undef, @named );
            next unless $family eq 'PCF' || $family eq 'VSM';
        }
        $add->(
            "1:2:3 with labels left offset 0.6,0.5 tc $colour",
            undef, @named
        );
    }
    return drawn(
        "work-$scene-$truth",
        $folder,
        join '',
        $HEAD,
        "set xlabel 'time of a frame, ms'\n",
        "set ylabel '$AXIS{$truth}'\n",
        axis( x => map { $_->{total_ms} } @points ),
        axis( y => map { error_of( $truth, $_ ) } @points ),
        @blocks,
        'plot ',
        join( ', ', @parts ),
        "\n"
    );
}

# The points that have a time, and an error against this truth.
sub judged {
    my ( $truth, @points ) = @_;
    return
      grep { defined $_->{total_ms} && defined $_->{"${truth}_rmse"} } @points;
}

# Drawn on a logarithmic axis, where there is no 0.
sub error_of {
    my ( $truth, $point ) = @_;
    my $error = $point->{"${truth}_rmse"};
    return $error > 1e-7 ? $error : 1e-7;
}

sub row {
    my ( $truth, $point ) = @_;
    return join ' ', $point->{total_ms}, error_of( $truth, $point ),
      $truth eq 'area' ? "\"$point->{label}\"" : $point->{width};
}

# The points that buy less error than all that are faster.
sub stair {
    my ( $truth, @points ) = @_;
    @points =
      sort { $a->{total_ms} <=> $b->{total_ms} } judged( $truth, @points );
    my ( $least, @corners );
    for (@points) {
        my $error = $_->{"${truth}_rmse"};
        next if defined $least && $error >= $least;
        $least = $error;
        push @corners, $_;
    }
    return @corners;
}

# Time against one column, a line for each technique.
sub growth {
    my ( $folder, $name, $column, $axis, %lines ) = @_;
    my ( @blocks, @parts, @drawn );
    for my $technique ( sort keys %lines ) {
        my @points =
          sort { $a->{$column} <=> $b->{$column} }
          grep { defined $_->{total_ms} } @{ $lines{$technique} };
        next if @points < 2;
        push @drawn, @points;
        my $family = $points[0]{family};
        my $dashes = $technique eq $family ? '' : 'dt ' . ( 2 + @parts % 4 );
        my ( $block, $part ) = series(
            scalar @parts,
            "1:2:3:4 with yerrorlines pt $MARK{$family} ps 0.7 $dashes "
              . "lc rgb '$COLOUR{$family}'",
            $technique,
            map { join ' ', @$_{ $column, qw(total_ms total_q1 total_q3) } }
              @points
        );
        push @blocks, $block;
        push @parts,  $part;
    }
    return ( '<p>Nothing is measured.</p>', '' ) unless @parts;
    return drawn(
        "growth-$name",
        $folder,
        join '',
        $HEAD,
        "set xlabel " . quoted($axis) . "\n",
        "set ylabel 'time of a frame, ms'\n",
        axis_at( x => map { $_->{$column} } @drawn ),
        axis( y => map { @$_{qw(total_q1 total_q3)} } @drawn ),
        @blocks,
        'plot ',
        join( ', ', @parts ),
        "\n"
    );
}

1;
