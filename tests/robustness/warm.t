# What the tests draw with (tests/warm.c) is the program: the same bytes, the
# same refusals, the same end.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

# What is left of a run: everything that it says and writes.
sub all_of {
    my ( $by, @words ) = @_;
    my $run   = $by->(@words);
    my @files = map { "$_: " . slurp($_) } everything_below('.');
    unlink everything_below('.');
    return join "\n", %$run{qw(err out signal status)}, @files;
}

for my $words (
    [ 1, qw(--size 32x18 --map-size 16 --output p.exr) ],
    [ 5, qw(--size 32x18 --map-size 16 --soft --output p.png) ],
    [ 5, qw(--soft --sat) ],
    [ 5, qw(--output missing/p.png) ],
    [ 1, '--no-such-option' ],
  )
{
    my ( $program, $warm ) = map { all_of( $_, @$words ) } \&run, \&run_warm;
    is( $warm, $program, "step @$words: the same" );
}

# Time runs out for both.
{
    local $VSM::SECONDS = 1;
    is( run_warm( 1, qw(--size 4000x4000 --bench 50 --output p.exr) )->{signal},
        14, 'one that takes too long is stopped' );
}

done_testing;
