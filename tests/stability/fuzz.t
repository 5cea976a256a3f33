# The formulas of steps 3 to 5 on random depths and on extreme ones, in float
# against long double: every error is within its bound (tests/stability/bound.h),
# p with `auto` is never below the lit share, and no bound is merely generous.
# Planted mistakes are found, those in the bound itself as well.
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

# The lesson's closed form is at least the number that guard.c proves for the
# same chain, and hardly more: of all radii, downsampled by 1, 2, 4, 8 and 16.
my @parts =
  command( $fuzz, '--closed-form' )->{out} =~ /^factor \d+: (\S+) to (\S+)$/mg;
is( scalar @parts, 10, 'closed form: five factors' );
cmp_ok( $_, '>=', 1, 'closed form: no less than the chain' ) for @parts;
cmp_ok( $_, '<=', 1.1, 'closed form: no more than a tenth more' ) for @parts;

for my $fault (qw(variance-sign naive-merge bound-tenth bound-tenfold)) {
    my $run = command( $fuzz, '--break', $fault );
    is( $run->{status}, 1, "$fault is found" );
    like( $run->{out}, qr/^depths 0x/m, 'and its worst window printed' );
}

# The rows of --cases as hashes.
sub cases {
    my ( $head, @lines ) = split /\n/, command( $fuzz, '--cases', @_ )->{out};
    my @rows;
    for (@lines) {
        my %row;
        @row{ split /,/, $head } = split /,/, $_, -1;
        push @rows, \%row;
    }
    return @rows;
}

# How many rows are beyond their bound or not finite, and in how many of those
# whose bound promises something a search reaches a tenth of it: of all, and of
# those without `auto`, which is a good part of its own bound.
sub summary {
    my @rows     = @_;
    my @promised = grep { $_->{searched} ne '' } @rows;
    my @bare     = grep { $_->{minimum} eq 'none' } @promised;
    my $share    = sub {
        return @_ ? grep( { $_->{searched} >= 0.1 } @_ ) / @_ : 0;
    };
    return (
        scalar( grep { !( $_->{ratio} <= 1 ) || $_->{nonfinite} } @rows ),
        scalar( grep { $_->{searched} > 1 } @promised ),
        $share->(@promised), $share->(@bare), scalar @promised
    );
}

my @rows = cases();
my ( $beyond, $searched, $all, $bare, $promised ) = summary(@rows);
is( $beyond,   0, scalar(@rows) . ' cases: finite, and within their bound' );
is( $searched, 0, "of $promised with a promise, a search leads beyond none" );
cmp_ok( $all,  '>=', 0.5, 'it reaches a tenth of half of the bounds' );
cmp_ok( $bare, '>=', 0.5, 'and of those without auto' );

# How far p is from 0.5 for two planes, half each, over a thousand depths.
sub largest {
    my ( $case, $format, $moments, $most ) = @_;
    my ($row) = grep {
             $_->{case} eq $case
          && $_->{format} eq $format
          && $_->{moments} eq $moments
          && $_->{minimum} eq 'none'
    } @rows;
    cmp_ok( $row->{largest}, '<=', $most, "$format $moments, $case: error" );
    return;
}
largest( 'gap 1e-5', 'fp32', 'central', 0.01 );
largest( 'gap 1e-2', 'fp16', 'central', 0.06 );

( $beyond, $searched ) = summary( cases(qw(--break bound-tenth)) );
cmp_ok( $beyond + $searched, '>', 0, 'bound-tenth: cases are beyond it' );
( undef, undef, undef, $bare ) = summary( cases(qw(--break bound-tenfold)) );
cmp_ok( $bare, '<', 0.5, 'bound-tenfold: the search says that it is generous' );

done_testing;
