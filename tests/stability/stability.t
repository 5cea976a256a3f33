# A few of the extreme cases of `make stability`: the error is within its bound,
# and every value is a number. Each row of its table is a test.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

local $ENV{STABILITY_OUT} = tempdir( CLEANUP => 1 );
my $run = command( $^X, root() . '/tests/stability/stability.pl', '--quick' );
my ($table) = $run->{out} =~ /^all of it: (.+)$/m
  or BAIL_OUT("stability.pl --quick: $run->{out}$run->{err}");
my ( $head, @lines ) = split /\n/, slurp($table);
my @names = split /,/, $head;
my %seen;
for my $line (@lines) {
    my %row;
    @row{@names} = split /,/, $line, -1;
    $seen{ $row{verdict} }++;
    my $what = join ' ',
      grep { $_ ne '' } @row{qw(case step quantity moments format minimum)};
    isnt( $row{verdict}, 'FAILED', $what )
      or diag("error $row{error}, bound $row{bound}, $row{note}");
}
ok( $seen{passed} && $seen{'no promise'} && $seen{refused},
    'rows of every kind' );
is( $run->{status}, 0, 'its exit status says so too' );
like( $run->{out}, qr/^\d+ passed, 0 failed\n\z/m, 'and its last line' );

done_testing;
