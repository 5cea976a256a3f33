#!/usr/bin/perl
# Error against run time: every step on three scenes, PCF and VSM at four
# widths, measured in one run. Prints a table and writes out/report/results.csv
# (its columns are named in its first line; times in milliseconds, errors of
# the visibility, memory in bytes). Ends with what the numbers have to show.
#
# The programs take turns: each runs once per round, so that a slow minute of
# the machine hits all of them alike.
use strict;
use warnings;
use FindBin;
use lib "$FindBin::Bin/../lib";
use File::Path qw(make_path remove_tree);
use JSON::PP qw(decode_json);
use VSM;

my @scenes = qw(teapot edge bleed:r=4);
my @widths = ( 3, 7, 15, 31 );
my @size   = ( '--size', $ENV{REPORT_SIZE} // '640x360' );
my ( $rounds, $frames ) = ( 5, 7 );    # 35 frames in all
my @truths = qw(lower pcf footprint hard);

# name, step, width in texels of the map, options
my @techniques = (
    [ 'hard',    1, 1 ],
    [ 'moments', 3, 1 ],
    map( { [ "PCF $_", 2, $_, '--kernel', $_ ] } @widths ),
    map( { [ "mean $_", 4, $_, '--radius', ( $_ - 1 ) / 2 ] } @widths ),
    map( {
            [
                "VSM $_", 5, $_, '--radius', ( $_ - 1 ) / 2,
                qw(--bleed-reduction 0)
            ]
    } @widths ),
);

my $folder = root() . '/out/report';
my $failed = 0;

# The programs' answers; a program that fails stops the report.
sub answer {
    my ( $what, $run ) = @_;
    $run->{status} == 0 && $run->{signal} == 0
      or die "$what: exit status $run->{status}, signal $run->{signal}: "
      . $run->{err};
    return $run->{out};
}

# The lines of a CSV table as hashes.
sub table {
    my ( $head, @lines ) = split /\n/, shift;
    my @names = split /,/, $head;
    my @rows;
    for my $line (@lines) {
        my %row;
        @row{@names} = split /,/, $line;
        push @rows, \%row;
    }
    return @rows;
}

# Errors against each truth, and the maps' bytes.
sub measure_errors {
    my ( $row, $dump ) = @_;
    remove_tree($dump);
    make_path($dump);
    answer( "$row->{technique} on $row->{scene}",
        run( $row->{step}, @{ $row->{options} },
            '--dump', $dump, '--output', "$dump/picture.png" ) );
    my $errors = answer(
        "errors of $row->{technique} on $row->{scene}",
        command( root() . '/build/oracle', 'errors', $dump )
    );
    for my $error ( table($errors) ) {
        for my $what (qw(pixels apart nonfinite rmse p99 max share)) {
            $row->{"$error->{truth}_$what"} = $error->{$what};
        }
    }
    $row->{map_bytes} = decode_json( slurp("$dump/run.json") )->{map_bytes};
    remove_tree($dump);
    return;
}

# One round of frames; their times are added to the row's.
sub measure_times {
    my ($row) = @_;
    my $times = answer(
        "$row->{technique} on $row->{scene}",
        run( $row->{step}, @{ $row->{options} },
            '--bench', $frames, '--output', "$folder/bench.png" )
    );
    for my $pass ( table($times) ) {
        push @{ $row->{medians}{ $pass->{pass} } }, $pass->{median_ms};
        push @{ $row->{samples}{ $pass->{pass} } },
          split / /, $pass->{samples_ms};
        $row->{clock} = $pass->{clock};
    }
    return;
}

sub quantile {
    my ( $part, @samples ) = @_;
    @samples = sort { $a <=> $b } @samples;
    my $place = $part * $#samples;
    my $index = int $place;
    my $next  = $index < $#samples ? $index + 1 : $index;
    return $samples[$index] +
      ( $place - $index ) * ( $samples[$next] - $samples[$index] );
}

# The first pass fills the map, whatever its name in that step.
sub summarise_times {
    my ($row) = @_;
    my %samples = %{ $row->{samples} };
    $samples{map} = $samples{depth} // $samples{moments};
    for my $pass (qw(map blur shading total)) {
        next unless $samples{$pass};
        $row->{"${pass}_ms"} = quantile( 0.5, @{ $samples{$pass} } );
        $row->{"${pass}_q1"} = quantile( 0.25, @{ $samples{$pass} } );
        $row->{"${pass}_q3"} = quantile( 0.75, @{ $samples{$pass} } );
    }
    $row->{frames} = @{ $samples{total} };
    return;
}

sub measure {
    my @rows;
    for my $scene (@scenes) {
        for (@techniques) {
            my ( $name, $step, $width, @options ) = @$_;
            push @rows,
              {
                scene     => $scene,
                technique => $name,
                step      => $step,
                width     => $width,
                options   => [ @size, '--scene', $scene, @options ],
              };
        }
    }
    for my $row (@rows) {
        print STDERR "errors: $row->{scene} $row->{technique}\n";
        measure_errors( $row, "$folder/dump" );
    }
    for my $round ( 1 .. $rounds ) {
        print STDERR "times: round $round of $rounds\n";
        measure_times($_) for @rows;
    }
    summarise_times($_) for @rows;
    unlink "$folder/bench.png";
    return @rows;
}

sub write_csv {
    my @rows    = @_;
    my @columns = qw(scene technique step width map_bytes frames clock);
    for my $truth (@truths) {
        push @columns, map { "${truth}_$_" }
          qw(pixels apart nonfinite rmse p99 max share);
    }
    for my $pass (qw(map blur shading total)) {
        push @columns, map { "${pass}_$_" } qw(ms q1 q3);
    }
    my $text = join( ',', @columns ) . "\n";
    for my $row (@rows) {
        $text .= join( ',', map { $row->{$_} // '' } @columns ) . "\n";
    }
    spew( "$folder/results.csv.partial", $text );
    rename "$folder/results.csv.partial", "$folder/results.csv"
      or die "cannot write $folder/results.csv: $!\n";
    return;
}

sub number {
    my ( $format, $value ) = @_;
    return defined $value && $value ne '' ? sprintf $format, $value : '-';
}

sub print_table {
    my @rows  = @_;
    my $scene = '';
    for my $row (@rows) {
        if ( $row->{scene} ne $scene ) {
            $scene = $row->{scene};
            # `lower` compares stored depths with t and grants no rounding: a
            # flat lit floor is all ties. It is for the inequality only.
            printf "\n%s, %s pixels; RMSE of the visibility against each truth, "
              . "median time (quartiles), clock %s\n", $scene, $size[1],
              $row->{clock};
            printf "%-10s %9s %9s %9s %9s %8s %8s %9s %24s %8s\n", '',
              @truths, qw(map blur shading), 'total, ms', 'MiB';
        }
        printf "%-10s %9s %9s %9s %9s %8.2f %8s %9.2f %24s %8.2f\n",
          $row->{technique},
          ( map { number( '%.5f', $row->{"${_}_rmse"} ) } @truths ),
          $row->{map_ms}, number( '%.2f', $row->{blur_ms} ),
          $row->{shading_ms},
          sprintf( '%.2f (%.2f-%.2f)', @$row{qw(total_ms total_q1 total_q3)} ),
          $row->{map_bytes} / 2**20;
    }
    return;
}

# What the numbers have to show, whatever the machine.
sub claim {
    my ( $holds, $text ) = @_;
    print $holds ? 'holds ' : 'FAILS ', $text, "\n";
    $failed++ unless $holds;
    return;
}

# How much longer one row's shading takes than another's: round by round, since
# the machine may be slower in one round than in the next; then the median.
sub ratio {
    my ( $row, $other ) = @_;
    my ( $these, $those ) = map { $_->{medians}{shading} } $row, $other;
    return quantile( 0.5, map { $these->[$_] / $those->[$_] } 0 .. $#$these );
}

sub check_claims {
    my %row = map { ( "$_->{scene} $_->{technique}" => $_ ) } @_;
    print "\n";
    my $bad = 0;
    for my $row (@_) {
        $bad += $row->{"${_}_nonfinite"} // 0 for @truths;
    }
    claim( $bad == 0, "values that are not finite: $bad" );
    for my $scene (@scenes) {
        my $pcf = ratio( @row{ "$scene PCF 31", "$scene PCF 7" } );
        my $vsm = ratio( @row{ "$scene VSM 31", "$scene VSM 7" } );
        claim( $pcf >= 8,
            sprintf '%s: shading, width 31 over 7: PCF %.1f', $scene, $pcf );
        claim( $vsm <= 1.2,
            sprintf '%s: shading, width 31 over 7: VSM %.2f', $scene, $vsm );
    }
    for my $width (@widths) {
        my $rmse = $row{"edge VSM $width"}{pcf_rmse};
        claim( $rmse <= 1e-4,
            sprintf 'edge: VSM %d against same-weights PCF: RMSE %.2g',
            $width, $rmse );
        my $largest = $row{"bleed:r=4 VSM $width"}{pcf_max};
        claim( abs( $largest / ( 4 / 6 )**2 - 1 ) <= 0.02,
            sprintf 'bleed, r = 4: largest error of VSM %d: %.4f, formula %.4f',
            $width, $largest, ( 4 / 6 )**2 );
    }
    # The steps' own defaults are 7 texels wide. Wider VSM need not be nearer
    # than hard shadows: the bound's own error grows with the width.
    my $hard = $row{'teapot hard'}{footprint_rmse};
    for my $name ( 'PCF 7', 'VSM 7' ) {
        my $rmse = $row{"teapot $name"}{footprint_rmse};
        claim( $rmse < $hard,
            sprintf 'teapot: %s is nearer to footprint truth than hard: '
              . 'RMSE %.4f, %.4f',
            $name, $rmse, $hard );
    }
    return;
}

make_path($folder);
$| = 1;
my @rows = measure();
write_csv(@rows);
print_table(@rows);
check_claims(@rows);
print "\nall of it: out/report/results.csv\n";
exit( $failed ? 1 : 0 );
