#!/usr/bin/perl
# The extreme cases, in every step that they apply to: what the numbers have
# lost against double precision, what they may lose (bound.h), their ratio, and
# how many values are not finite. Prints a table and writes
# out/stability/results.csv (or below STABILITY_OUT); ends with "N passed, M
# failed".
#     stability.pl          all of it
#     stability.pl --quick  the few cases of `make test`
#     stability.pl PATTERN  the cases whose name matches, without the formulas
use strict;
use warnings;
use FindBin;
use lib "$FindBin::Bin/../lib", $FindBin::Bin;
use Cases qw(@cases);
use File::Basename qw(dirname);
use File::Path qw(make_path remove_tree);
use File::Temp qw(tempdir);
use VSM;

my $QUICK  = grep { $_ eq '--quick' } @ARGV;
my ($ONLY) = grep { !/^--/ } @ARGV;
my $folder = $ENV{STABILITY_OUT} // root() . '/out/stability';
my $work   = tempdir( CLEANUP => 1 );
my $fuzz   = dirname( program(1) ) . '/fuzz';

my @WORKERS = 1 .. 2;

# What the last roundings of p may take from the lit share (bound.h).
my $LAST_ROUNDINGS = 12 * 2**-24;
# Fewer pixels with a promise than this share of those behind the mean: none.
my $LEAST_SHARE = 0.01;
# What has to be there in the end.
my $LEAST_COUNTED = 60;
my $LEAST_REACHED = 0.1;    # of a bound, in half of the rows

my @COLUMNS = qw(case step quantity moments format minimum compared all error
  bound ratio searched nonfinite below verdict note);

# --- the runs ---------------------------------------------------------------

# The driver's limit, from what it says when asked for more.
sub limit {
    my $run = run( 1, qw(--map-size 32768 --output), "$work/a.png" );
    my ($limit) = $run->{err} =~ /limit of (\d+)x/
      or die "no limit in: $run->{err}\n";
    return $limit;
}

# What is stored in the steps that store moments, and step 5's least variance:
# moments, format, minimum, options.
sub variants {
    my ( $case, $step ) = @_;
    return [ '', '', '' ] if $step < 3;
    my @formats  = $case->{formats} ? qw(fp32 fp16) : qw(fp32);
    my %format   = ( fp32 => 'rg32f', fp16 => 'rg16f' );
    my @minimums = $step < 5 ? '' : @{ $case->{minimums} // [qw(auto 0)] };
    @minimums = $minimums[0] if $QUICK && !$case->{formats};
    my @variants;
    for my $moments (qw(raw central)) {
        for my $format (@formats) {
            my @stored = ( '--moments', $moments, '--format', $format{$format} );
            push @variants,
              map {
                [
                    $moments, $format, $_, @stored,
                    $_ ne '' ? ( '--min-variance', $_ ) : ()
                ]
              } @minimums;
        }
    }
    return @variants;
}

# A run of the program for each step and variant of a case.
sub jobs {
    my ($limit) = @_;
    my @jobs;
    for my $case ( grep { !defined $ONLY || $_->{name} =~ /$ONLY/ } @cases ) {
        my $map = $case->{map} // 128;
        $map =~ s/LIMIT/$limit/;
        $map =~ s/BEYOND/2 * $limit/e;
        for my $step ( $QUICK ? @{ $case->{quick} // [] } : 1 .. 5 ) {
            for my $variant ( variants( $case, $step ) ) {
                my ( $moments, $format, $minimum, @stored ) = @$variant;
                push @jobs,
                  {
                    case    => $case,
                    step    => $step,
                    moments => $moments,
                    format  => $format,
                    minimum => $minimum,
                    options => [
                        '--size',
                        $case->{size} // '160x90',
                        '--map-size',
                        $map,
                        @stored,
                        $step == 5 ? qw(--bleed-reduction 0) : (),
                        @{ $case->{options} },
                        @{ $case->{step}{$step} // [] },
                    ],
                  };
            }
        }
    }
    return @jobs;
}

sub row_of {
    my ( $job, %more ) = @_;
    return {
        case    => $job->{case}{name},
        step    => $job->{step},
        moments => $job->{moments},
        format  => $job->{format},
        minimum => $job->{minimum},
        %more
    };
}

# The lines of a CSV table as hashes.
sub table {
    my ( $head, @lines ) = split /\n/, shift;
    my @names = split /,/, $head;
    my @rows;
    for my $line (@lines) {
        my %row;
        @row{@names} = split /,/, $line, -1;
        push @rows, \%row;
    }
    return @rows;
}

sub fails {
    my ( $job, $note ) = @_;
    $note =~ tr/,\n/; /;
    return row_of( $job, verdict => 'FAILED', note => $note );
}

sub refused_row {
    my ( $job, $pattern, $run ) = @_;
    return fails( $job, "exit status $run->{status}: $run->{err}" )
      unless ( $run->{status} == 1 || $run->{status} == 2 )
      && !$run->{signal}
      && $run->{err} =~ /\A[^\n]*$pattern[^\n]*\n\z/;
    return row_of( $job, verdict => 'refused', note => 'with one line' );
}

# Whether two pictures are the same but for 1/255 on a thousandth of the pixels.
sub picture_row {
    my ( $job, $picture, $base ) = @_;
    my $run = ask_oracle( 'compare', $picture, $base );
    my ($over) = $run->{out} =~ m{share over 1/255 (\S+)}
      or return fails( $job, "compare: $run->{out}" );
    return row_of(
        $job,
        quantity  => 'picture',
        compared  => 1,
        all       => 1,
        error     => $over,
        bound     => 0.001,
        ratio     => $over / 0.001,
        searched  => '',
        nonfinite => 0,
        below     => 0,
    );
}

# Scene edge: the exact visibility is known. Its bound is the widest of all
# pixels under whose filter both depths are, where it is not above 0.1.
sub closed_form_row {
    my ( $job, $dump ) = @_;
    my $out = ask_oracle( 'edge', $dump )->{out};
    return row_of( $job, verdict => 'no promise', quantity => 'lit share',
        note => 'the gap is lost in t itself' )
      if $out =~ /the gap is lost/;
    my ( $wrong, $mixed, $worst, $bound, $untested ) =
      $out =~ /lit \s share: \s (\d+) \s of .*? \( (\d+) \s with .*? worst
               \s (\S+), \s widest \s bound \s (\S+), \s (\d+) \s untested/x
      or return fails( $job, $out );
    return row_of(
        $job,
        quantity  => 'lit share',
        compared  => $mixed,
        all       => $mixed + $untested,
        error     => $worst,
        bound     => $bound,
        ratio     => $wrong ? 'inf' : $bound > 0 ? $worst / $bound : 0,
        searched  => '',
        nonfinite => 0,
        below     => 0,
    );
}

# The rows of one run.
sub rows_of {
    my ( $job, $dump ) = @_;
    my ( $case, $step ) = @$job{qw(case step)};
    my $reason = $case->{not}{$step};
    return row_of( $job, verdict => 'not', note => $reason ) if defined $reason;
    return row_of( $job, verdict => 'not', note => 'one depth has no variance' )
      if $step == 3 && $job->{moments} eq 'central';
    remove_tree($dump);
    make_path($dump);
    my @options = @{ $job->{options} };
    my $run     = run_warm( $step, @options, '--dump', $dump, '--output',
        "$dump.exr" );
    my $pattern = $case->{refused}{$step};
    return refused_row( $job, $pattern, $run ) if $pattern;
    return fails( $job, "exit status $run->{status}: $run->{err}" )
      if $run->{status} || $run->{signal};
    my $answer = ask_oracle( 'stability', $dump );
    return fails( $job, $answer->{out} ) if $answer->{status};
    my @rows = map { row_of( $job, %$_ ) } table( $answer->{out} );
    push @rows, closed_form_row( $job, $dump )
      if $case->{closed} && ( $step == 2 || $step == 5 );
    if ( $case->{picture} ) {
        run_warm( $step, @options, @{ $case->{picture} }, '--output',
            "$dump.base.exr" );
        push @rows, picture_row( $job, "$dump.exr", "$dump.base.exr" );
    }
    return @rows;
}

# --- the verdicts -----------------------------------------------------------

sub judge {
    my ($row) = @_;
    return if defined $row->{verdict};
    $row->{note} //= '';
    my $holds =
         $row->{nonfinite} == 0
      && $row->{ratio} <= 1
      && ( $row->{searched} || 0 ) <= 1
      && $row->{below} <= $LAST_ROUNDINGS;
    my $share = $row->{all} ? $row->{compared} / $row->{all} : 0;
    $row->{verdict} =
        !$holds           ? 'FAILED'
      : $row->{all} == 0  ? 'passed'
      : $share < $LEAST_SHARE && $row->{quantity} =~ /^p$|^lit/ ? 'no promise'
      :                                                    'passed';
    $row->{note} = 'nothing is behind its mean' if $row->{all} == 0;
    return;
}

# A row with a bound that says something.
sub counts {
    my ($row) = @_;
    return ( $row->{verdict} eq 'passed' || $row->{verdict} eq 'FAILED' )
      && $row->{compared}
      && $row->{bound} > 0;
}

# The formulas alone, without a picture (cases.c).
sub formula_rows {
    my $run = command( $fuzz, '--cases' );
    die "fuzz --cases: exit status $run->{status}\n" if $run->{status};
    my @rows;
    for my $row ( table( $run->{out} ) ) {
        push @rows,
          {
            %$row,
            case     => "$row->{case} ($row->{taps} taps)",
            step     => 'formula',
            quantity => 'p',
            all      => 1000,
            compared => $row->{searched} eq '' ? 0 : 1000,
            below    => 0,
          };
    }
    return @rows;
}

# --- the table --------------------------------------------------------------

sub write_csv {
    my @rows = @_;
    my $text = join( ',', @COLUMNS ) . "\n";
    for my $row (@rows) {
        $text .= join(
            ',',
            map {
                my $value = $row->{$_} // '';
                $value =~ tr/,/;/;
                $value
            } @COLUMNS
        ) . "\n";
    }
    spew( "$folder/results.csv", $text );
    return;
}

sub number {
    my ( $format, $value ) = @_;
    return defined $value && $value ne '' ? sprintf $format, $value : '-';
}

my $LAYOUT = "%-38.38s %-7s %-10s %-22s %-4s";

sub print_head {
    printf "$LAYOUT %5s %8s %8s %6s %6s %2s %s\n", 'case', 'step', 'quantity',
      'stored', 'min.', 'of', 'error', 'bound', 'ratio', 'search', 'nf',
      'verdict';
    return;
}

sub print_row {
    my ($row) = @_;
    my %cell = map { $_ => $row->{$_} // '' } @COLUMNS;
    my $line = sprintf $LAYOUT, @cell{qw(case step quantity)},
      "$cell{moments} $cell{format}", $cell{minimum};
    my $verdict = $row->{verdict} . ( $cell{note} ? ": $cell{note}" : '' );
    if ( !defined $row->{ratio} ) {
        print "$line $verdict\n";
        return;
    }
    my $share = $row->{all} ? 100 * $row->{compared} / $row->{all} : 0;
    printf "%s %4.0f%% %8s %8s %6s %6s %2d %s\n", $line, $share,
      map( { number( '%.1e', $_ ) } @$row{qw(error bound)} ),
      map( { number( '%.3f', $_ ) }
        $row->{compared} ? $row->{ratio} : '', $row->{searched} ),
      $row->{nonfinite}, $verdict;
    return;
}

# The rows of all jobs, in their order; each worker takes every other one.
sub run_jobs {
    my @jobs = @_;
    my @children;
    for my $worker (@WORKERS) {
        my $child = fork // die "cannot fork: $!\n";
        if ( $child == 0 ) {
            for ( my $i = $worker - 1 ; $i < @jobs ; $i += @WORKERS ) {
                my @rows = rows_of( $jobs[$i], "$work/dump$worker" );
                judge($_) for @rows;
                spew( "$work/$i",
                    join "\n", map { encode($_) } @rows );
            }
            exit 0;
        }
        push @children, $child;
    }
    my @rows;
    for my $child (@children) {
        waitpid $child, 0;
        die "a worker stopped with $?\n" if $?;
    }
    for my $i ( 0 .. $#jobs ) {
        push @rows, map { decode($_) } split /\n/, slurp("$work/$i");
    }
    return @rows;
}

# A row as a line, and back.
sub encode {
    my ($row) = @_;
    return join "\t", map { ( $_, $row->{$_} ) }
      grep { defined $row->{$_} } sort keys %$row;
}

sub decode {
    return { split /\t/, $_[0], -1 };
}

sub claim {
    my ( $holds, $text ) = @_;
    print $holds ? 'holds ' : 'FAILS ', $text, "\n";
    return $holds ? 0 : 1;
}

$| = 1;
my @rows = run_jobs( jobs( $QUICK ? 0 : limit() ) );
my $ALL = !$QUICK && !defined $ONLY;
if ($ALL) {
    my @formulas = formula_rows();
    judge($_) for @formulas;
    push @rows, @formulas;
}
print_head();
print_row($_) for @rows;
write_csv(@rows);

my %verdicts;
$verdicts{ $_->{verdict} }++ for @rows;
my @counted = grep { counts($_) } @rows;
my @reached =
  grep { ( $_->{searched} || 0 ) >= $LEAST_REACHED } @counted;
my $failed = $verdicts{FAILED} // 0;
print "\n";
if ($ALL) {
    $failed += claim( @counted >= $LEAST_COUNTED,
        sprintf '%d rows are counted, at least %d', scalar @counted,
        $LEAST_COUNTED );
    $failed += claim( 2 * @reached >= @counted,
        sprintf 'in %d of them a search reaches a tenth of the bound: at least '
          . 'half', scalar @reached );
}
printf "%d no promise, %d refused as they have to be, %d that do not apply\n",
  map { $verdicts{$_} // 0 } 'no promise', 'refused', 'not';
printf "all of it: %s\n", "$folder/results.csv" =~ s{^\Q@{[root()]}/\E}{}r;
printf "%d passed, %d failed\n",
  ( $verdicts{passed} // 0 ) + ( $verdicts{refused} // 0 ), $failed;
exit( $failed ? 1 : 0 );
