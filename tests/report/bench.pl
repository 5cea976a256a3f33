#!/usr/bin/perl
# How the time of a frame grows with the filter's width, the map, the triangles,
# the picture and the layers, and whether what is claimed of it holds. Prints
# a table, and writes out/bench/results.csv (or below BENCH_OUT).
#
# The programs take turns: each runs once per round, so that a slow minute of
# the machine hits all of them alike. The second and third round leave out
# what took long, and a round is begun only in the first minutes; BENCH_SECONDS
# says how many seconds (300).
#
# Exit status: 0 all is measured and no claim fails, though aims may be missed
# and what a busy machine does not let tell is unclear, 1 one fails, 2 bad usage
# or no place to write, 3 something is missing.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin, "$FindBin::Bin/../lib";
use File::Path  qw(make_path);
use Time::HiRes qw(time);
use VSM;
use Bench   qw(@SWEEPS @CLAIMS @GROWTHS points);
use Growth  qw(exponent);
use Judge   qw(lies_between ratio spread);
use Measure qw(processors quantile summarise times_of);
use Startup qw(starts_within startup);

use constant {
    ROUNDS  => 3,
    FRAMES  => 5,      # of a run; of one that took long one
    LONG    => 6,      # seconds
    TIMEOUT => 300,
    START   => 0.6,    # seconds until there is a picture
};

my $folder  = $ENV{BENCH_OUT}     // root() . '/out/bench';
my $seconds = $ENV{BENCH_SECONDS} // 300;

# --- measuring ---------------------------------------------------------------

# The larger of a sweep's values come last and take longest: what took long at
# one is given a single frame at the next.
sub measure_round {
    my ( $round, $points, $slow ) = @_;
    for my $point (@$points) {
        my $name = "$point->{sweep} $point->{run}";
        next if $point->{missing} || $round > 0 && $point->{took} > LONG;
        my $frames = $slow->{$name} ? 1 : FRAMES;
        my $begun  = time;
        my $times  = eval { times_of( $point, $frames ) };
        $point->{took} = time - $begun;
        $slow->{$name} = 1 if $point->{took} > LONG;
        if ($times) { push @{ $point->{timed} }, $times }
        else        { $point->{missing} = $@ =~ s/\n\z//r }
        print STDERR '.';
    }
    print STDERR "\n";
    return;
}

sub measure {
    my @points = @_;
    my $begun  = time;
    my %slow;
    for my $round ( 0 .. ROUNDS - 1 ) {
        last if $round > 0 && time - $begun > $seconds;
        print STDERR 'round ', $round + 1, ': ';
        measure_round( $round, \@points, \%slow );
    }
    summarise( $_, @{ $_->{timed} } ) for grep { $_->{timed} } @points;
    return;
}

# --- what was found ----------------------------------------------------------

# The median of a pass, or the sum of those of several; or that of another
# quartile, q1 or q3.
sub time_of {
    my ( $point, $passes, $quartile ) = @_;
    my $sum = 0;
    $sum += $point->{ "${_}_" . ( $quartile // 'ms' ) } // return
      for split /\+/, $passes;
    return $sum;
}

# The measured points of one run of a sweep.
sub points_of {
    my ( $sweep, $run, $passes, @points ) = @_;
    return grep {
             $_->{sweep} eq $sweep
          && $_->{run} eq $run
          && !$_->{missing}
          && defined time_of( $_, $passes )
    } @points;
}

# The same as [value, milliseconds].
sub series {
    my ( $sweep, $run, $passes, @points ) = @_;
    return map { [ $_->{value}, time_of( $_, $passes ) ] }
      points_of( $sweep, $run, $passes, @points );
}


sub last_exponent {
    my @series = @_;
    return exponent( @series[ -2, -1 ] ) if @series > 1;
    return;
}

# The least and the most that it may be, by quartiles.
sub exponents {
    my ( $sweep, $run, $passes, @points ) = @_;
    my ( $before, $last ) =
      ( points_of( $sweep, $run, $passes, @points ) )[ -2, -1 ];
    return map {
        exponent(
            [ $before->{value}, time_of( $before, $passes, $_->[0] ) ],
            [ $last->{value},   time_of( $last,   $passes, $_->[1] ) ]
        )
    } [qw(q3 q1)], [qw(q1 q3)];
}

sub number {
    my ($value) = @_;
    return '-' unless defined $value;
    return sprintf( '%.2f', $value ) =~ s/^-(?=0\.00$)//r;
}

sub print_sweep {
    my ( $sweep, @points ) = @_;
    printf "\n%s: %s\n%-28s%7s%7s", @$sweep{qw(name unit)},
      'milliseconds, medians', qw(p last);
    printf '%10d', $_ for @{ $sweep->{values} };
    print "\n";
    for my $run ( @{ $sweep->{runs} } ) {
        for my $passes ( @{ $run->{passes} } ) {
            my @series =
              series( $sweep->{name}, $run->{name}, $passes, @points );
            my %time = map { @$_ } @series;
            printf '%-28s%7s%7s', "$run->{name}: $passes",
              map { number($_) } exponent(@series), last_exponent(@series);
            printf '%10s', number( $time{$_} ) for @{ $sweep->{values} };
            print "\n";
        }
    }
    return;
}

# Each: whether it holds, or where it is an aim is reached, in a word; and a
# line that says so. Nothing of what was not measured.
sub verdict {
    my ( $holds, $aim ) = @_;
    return 'unclear' unless defined $holds;
    return $holds ? 'reached' : 'missed' if $aim;
    return $holds ? 'holds'   : 'FAILS';
}

sub growth_claims {
    my @points = @_;
    my @claims;
    for my $growth (@GROWTHS) {
        my ($sweep) = grep { $_->{name} eq $growth->{sweep} } @SWEEPS;
        my ($run) =
          grep { $_->{name} eq $growth->{run} } @{ $sweep->{runs} };
        my @of = ( @$growth{qw(sweep run)}, $run->{passes}[0], @points );
        my $p  = last_exponent( series(@of) );
        next unless defined $p;
        my ( $least, $most ) = @$growth{qw(least most)};
        push @claims,
          [
            verdict(
                scalar lies_between(
                    $least // -1e9, $most // 1e9, $p, exponents(@of)
                )
            ),
            sprintf '%s over %s, last exponent: %.2f, at %s',
            $growth->{run},
            $growth->{sweep},
            $p,
            defined $least ? "least $least" : "most $most"
          ];
    }
    return @claims;
}

sub ratio_claims {
    my @points = @_;
    my @claims;
    for my $claim (@CLAIMS) {
        my ( $this, $that ) =
          grep { $_->{sweep} eq 'claim' && $_->{run} eq $claim->{text} }
          @points;
        next if $this->{missing} || $that->{missing};
        my $ratio = ratio( $claim->{pass}, $this, $that );
        my $most  = $claim->{aim} // $claim->{most};
        my @range =
          spread( map { [ @$_{ map { "$claim->{pass}_$_" } qw(q1 q3) } ] }
              $this, $that );
        push @claims,
          [
            verdict(
                scalar lies_between( 0, $most, $ratio, @range ),
                $claim->{aim}
            ),
            sprintf '%s: %.2f, at most %s',
            $claim->{text}, $ratio, $most
          ];
    }
    return @claims;
}

# From the start to a picture on disk: a claim, after it is printed.
sub startup_claim {
    my ( $whole, $waits, @parts ) = startup( $seconds > 0 ? 9 : 1 );
    print "\nstep 5's default picture, seconds from the start to the file\n";
    printf "%-38s%6.3f\n", @$_ for @parts;
    return [
        verdict( starts_within( START, $whole, $waits ) ),
        sprintf 'from the start to the file: %.3f seconds, at most %s',
        $whole, START
    ];
}

sub write_results {
    my @points = @_;
    my $text   = "sweep,run,value,pass,median_ms,q1_ms,q3_ms,frames,clock\n";
    for my $point ( grep { !$_->{missing} } @points ) {
        for my $pass (qw(map blur shading total)) {
            next unless defined $point->{"${pass}_ms"};
            $text .= join ',', "\"$point->{sweep}\"", "\"$point->{run}\"",
              $point->{value}, $pass,
              @$point{ map { "${pass}_$_" } qw(ms q1 q3) },
              "$point->{frames},$point->{clock}\n";
        }
    }
    spew( "$folder/results.csv", $text );
    return;
}

sub main {
    my @points = points();
    $seconds =~ /^\d+$/
      or die "BENCH_SECONDS=$seconds: a number of seconds is needed\n";
    local $VSM::SECONDS = TIMEOUT;
    make_path($folder);
    measure(@points);
    write_results(@points);
    my @processors = processors();
    printf "%s x %d, t ~ x^p by least squares of logarithms; last: p between "
      . "the last two\n", $processors[0], scalar @processors;
    print_sweep( $_, @points ) for @SWEEPS;
    my @claims =
      ( startup_claim(), growth_claims(@points), ratio_claims(@points) );
    print "\n", map { "@$_\n" } @claims;
    my @missing = grep { $_->{missing} } @points;
    print "MISSING $_->{sweep} $_->{run} $_->{value}: $_->{missing}\n"
      for @missing;
    return 3 if @missing;
    return grep( { $_->[0] eq 'FAILS' } @claims ) ? 1 : 0;
}

$| = 1;
my $status = eval { main() };
print STDERR "bench: $@" unless defined $status;
exit( $status // 2 );
