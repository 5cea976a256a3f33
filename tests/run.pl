#!/usr/bin/perl
# Runs the named .t files (-r and folders: all below them) as prove does, two
# at a time, and ends with "N passed, N failed".
use strict;
use warnings;
use File::Find;
use File::Temp qw(tempdir);
use TAP::Harness;

my @files;
for my $name (grep { $_ ne '-r' } @ARGV) {
    -e $name or die "there is no $name\n";
    find(
        {
            wanted   => sub { push @files, $_ if /\.t$/ },
            no_chdir => 1
        },
        $name
    );
}
@files = sort @files;
@files or die "no test to run\n";

# Where all temporary folders of the tests are; what one leaves that is killed
# goes with it.
$ENV{TMPDIR} = tempdir( 'vsm-XXXXXX', TMPDIR => 1, CLEANUP => 1 );
$SIG{INT} = $SIG{TERM} = sub { exit 1 };

my $harness =
  TAP::Harness->new( { jobs => 2, lib => ['tests/lib'], timer => 1 } );
my $result = $harness->runtests(@files);

# A file that stopped before its end counts, besides its failed tests.
my $failed = $result->failed + grep { $_->exit || $_->parse_errors }
  grep { !$_->failed } $result->parsers;
printf "%d passed, %d failed\n", scalar $result->passed, $failed;
exit( $failed ? 1 : 0 );
