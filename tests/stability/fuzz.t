# The formulas of steps 3 to 5 on random depths, in float against long double:
# every error is within its bound (tests/stability/bound.h), and p with `auto`
# is never below the lit share. And the fuzzing finds planted mistakes.
use strict;
use warnings;

use Test::More;
use VSM;

my $fuzz = ( $ENV{VSM_BUILD} // root() . '/build' ) . '/fuzz';

for my $seed ( 1, 2 ) {
    my $run = command( $fuzz, '--count', 5000, '--seed', $seed );
    is( $run->{status}, 0, "seed $seed: within the bound" );
    like( $run->{out}, qr/^5000 windows, 0 beyond the bound/, 'all of them' )
      or diag( $run->{out} );
}
is( command( $fuzz, '--count', 50 )->{out},
    command( $fuzz, '--count', 50 )->{out}, 'the same windows every time' );

for my $fault ( 'variance-sign', 'naive-merge' ) {
    my $run = command( $fuzz, '--break', $fault );
    is( $run->{status}, 1, "$fault is found" );
    like( $run->{out}, qr/^depths 0x/m, 'and its worst window printed' );
}

done_testing;
