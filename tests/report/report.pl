#!/usr/bin/perl
# Error against run time: techniques on scenes at several widths, measured in
# one run. Prints a table, and writes into out/report/ (or REPORT_OUT):
#     index.html     the page, in one file
#     results.csv    a row per point; Columns.pm says what a column means
#     results.json   the machine, the drivers, what was left out, the columns
#     kept/          what was measured, by what it depends on
# REPORT=quick takes 2 minutes, for a first look; REPORT=headline measures what
# headline.sh draws, REPORT=tiny is for tests.
#
# The programs take turns: each runs once per round, so that a slow minute of
# the machine hits all of them alike. Ctrl-C ends the measuring; the next run
# goes on from there.
#
# Exit status: 0 all is measured and the claims hold, 1 one does not, 2 bad
# usage or no place to write, 3 something is missing.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin, "$FindBin::Bin/../lib";
use File::Path qw(make_path);
use JSON::PP   ();
use POSIX      qw(strftime);
use Text::Wrap qw(wrap);
use VSM;
use Columns qw(@COLUMNS csv);
use Html    qw(names_of);
use Judge   qw(busy claims mark_front outcome);
use Measure qw(measure processors);
use Page    qw(page);
use Sweep   qw(mode sweep);
use Verdict qw(verdict);

my $folder = $ENV{REPORT_OUT} // root() . '/out/report';

# A file is there whole or not at all.
sub write_whole {
    my ( $name, $text ) = @_;
    my $path = "$folder/$name";
    return
      if eval { spew( "$path.partial", $text ) || 1 }
      && rename "$path.partial", $path;
    my $why = $@ || "cannot write $path: $!\n";
    unlink "$path.partial";
    die $why;
}

sub line_of {
    my @command = @_;
    my $run     = command( '/usr/bin/env', @command );
    return $run->{status} == 0 ? $run->{out} =~ s/\n.*//sr : 'unknown';
}

# What the numbers were measured on.
sub environment {
    my ( $mode, @points ) = @_;
    my @processors = processors();
    my ($any)      = grep { $_->{gl_renderer} } @points;
    my ($clock)    = map  { $_->{clock} // () } @points;
    return {
        mode        => $mode->{name},
        picture     => $mode->{size},
        rays        => $mode->{rays},
        date        => strftime( '%Y-%m-%dT%H:%M:%SZ', gmtime ),
        commit      => line_of(qw(git describe --always --dirty --abbrev=12)),
        cpu         => $processors[0] || line_of(qw(uname -m)),
        cores       => scalar @processors,
        system      => line_of(qw(uname -sr)),
        gl_renderer => $any->{gl_renderer} // 'unknown',
        gl_version  => $any->{gl_version}  // 'unknown',
        clock       => $clock              // 'unknown',
    };
}

sub number {
    my ( $format, $value ) = @_;
    return defined $value ? sprintf $format, $value : '-';
}

sub print_table {
    my ( $size, @points ) = @_;
    my $scene = '';
    for my $point (@points) {
        if ( $point->{scene} ne $scene ) {
            $scene = $point->{scene};
            printf "\n%s, %s pixels; RMSE of the visibility against each "
              . "truth, median time (quartiles)\n", $scene, $size;
            printf "%-28s %9s %9s %9s %8s %8s %9s %24s %8s\n", '',
              qw(pcf footprint light map blur shading), 'total, ms', 'MiB';
        }
        printf "%-28s %9s %9s %9s %8s %8s %9s %24s %8s%s\n", $point->{label},
          ( map { number( '%.5f', $point->{"${_}_rmse"} ) }
              qw(pcf footprint light) ),
          ( map { number( '%.2f', $point->{"${_}_ms"} ) }
              qw(map blur shading) ),
          defined $point->{total_ms}
          ? sprintf( '%.2f (%.2f-%.2f)',
            @$point{qw(total_ms total_q1 total_q3)} )
          : '-',
          number( '%.2f', $point->{map_bytes} && $point->{map_bytes} / 2**20 ),
          $point->{front} ? ' *' : '';
    }
    print "\n*: no point of the scene is clearly faster and no more wrong\n";
    return;
}

sub print_verdicts {
    my @points = @_;
    my @scenes = names_of( 'scene', @points );
    for my $scene (@scenes) {
        my @own = grep { $_->{scene} eq $scene } @points;
        print wrap( '', '    ', join ' ', "$scene:", verdict( $scene, @own ) ),
          "\n";
    }
    return;
}

sub print_claims {
    my @claims = @_;
    print outcome($_), ' ', $_->{text}, "\n" for @claims;
    return;
}

sub print_missing {
    my %by_reason;
    push @{ $by_reason{ $_->{missing} } }, "$_->{scene} $_->{label}" for @_;
    for my $reason ( sort keys %by_reason ) {
        my @points = @{ $by_reason{$reason} };
        my $more   = @points > 3 ? sprintf ' and %d more', @points - 3 : '';
        splice @points, 3;
        print 'MISSING ', join( ', ', @points ), "$more: $reason\n";
    }
    return;
}

sub write_results {
    my ( $mode, $points, $left_out, $claims ) = @_;
    my $environment = environment( $mode, @$points );
    write_whole( 'results.csv', csv(@$points) );
    my $json = JSON::PP->new->canonical->pretty;
    write_whole(
        'results.json',
        $json->encode(
            {
                environment => $environment,
                left_out    => $left_out,
                claims      => $claims,
                columns     =>
                  [ map { { name => $_->[0], meaning => $_->[1] } } @COLUMNS ],
                missing => [
                    map {
                        {
                            what   => "$_->{scene} $_->{label}",
                            reason => $_->{missing}
                        }
                    } grep { $_->{missing} } @$points
                ],
            }
        )
    );
    my ( $page, @problems ) = page(
        $folder,
        points      => $points,
        environment => $environment,
        left_out    => $left_out,
        claims      => $claims
    );
    write_whole( 'index.html', $page );
    return @problems;
}

sub main {
    my $mode = mode( $ENV{REPORT} // 'full' );
    my ( $points, $left_out ) = sweep($mode);
    my $stopped = 0;
    local $SIG{INT} = local $SIG{TERM} = sub { $stopped = 1 };
    my $reused = measure( $points, $mode, $folder, \$stopped );
    mark_front(@$points);
    my @claims  = claims(@$points);
    my @missing = grep { $_->{missing} } @$points;
    print_table( $mode->{size}, @$points );
    print_verdicts(@$points);
    print join '', map { "$_\n" } grep { $_ ne '' } busy(@$points);
    print_claims(@claims);
    print_missing(@missing);
    my @problems = write_results( $mode, $points, $left_out, \@claims );
    print "MISSING $_\n" for @problems;
    printf "\n%d points, %d of them from an earlier run; %d missing; all of "
      . "it: %s\n", scalar @$points, $reused, scalar @missing,
      "$folder/index.html";
    return 3 if @missing || @problems;
    return grep( { outcome($_) eq 'FAILS' } @claims ) ? 1 : 0;
}

$|            = 1;
$VSM::SECONDS = 600;    # for one command, on a machine as busy as it may be
my $status = eval { main() };
print STDERR "report: $@" unless defined $status;
exit( $status // 2 );
