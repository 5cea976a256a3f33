# Where the error comes from: the chain from the light's truth to the program
# blames each link for what it does, on scenes where that is known, and its
# signed differences add up.
use strict;
use warnings;
use Test::More;
use VSM;

my @small = qw(--size 320x180 --map-size 256);
my @bare  = ( @small, qw(--moments central --bleed-reduction 0) );

sub rows_of {
    my ( $dump, @words ) = @_;
    return oracle_errors( $dump, 'chain=1', 'rays=16', @words );
}

sub at_most {
    my ( $value, $most, $name ) = @_;
    return ok( defined $value && $value <= $most,
        "$name: " . ( $value // 'none' ) . ", at most $most" );
}

sub between {
    my ( $value, $least, $most, $name ) = @_;
    return ok(
        defined $value && $value >= $least && $value <= $most,
        "$name: " . ( $value // 'none' ) . " in $least .. $most"
    );
}

# Each difference of two floats of at most 1 is rounded once, by 2^-25 at
# most, and so is the one that they have to add up to.
sub telescopes {
    my ( $name, $step, $links, @options ) = @_;
    my $dump  = dump_run( $step, @options );
    my %rows  = rows_of( $dump, "write=$dump/chain" );
    my @found = sort map { /^chain\.(.*)/ } keys %rows;
    is( "@found", join( ' ', sort @$links ), "$name: the links" );
    my $floats = sub { unpack 'f*', slurp("$dump/chain/error.$_[0].bin") };
    my @whole  = $floats->('hard');
    my @sum    = (0) x @whole;
    my %moved;

    for my $link (@$links) {
        my @link = $floats->("chain.$link");
        for ( 0 .. $#link ) {
            next unless $link[$_];
            $sum[$_] += $link[$_];
            $moved{$_} = 1;
        }
    }
    my $most  = ( @$links + 1 ) * 2**-25;
    my @wrong = grep { abs( $sum[$_] - $whole[$_] ) > $most } 0 .. $#whole;

    # Where some link does not count a pixel, none does.
    my $apart = $rows{hard}{pixels} - $rows{"chain.$links->[0]"}{pixels};
    my $real  = grep { $moved{$_} } @wrong;
    ok(
        !$real && @wrong <= $apart && keys %moved,
        "$name: the links add up on every pixel"
    ) or diag("$real of ${\scalar @wrong} pixels wrong, $apart apart");
    my $mean = 0;
    $mean += $rows{"chain.$_"}{mean} for @$links;
    return ( $mean, %rows );
}

my @pcf = qw(footprint pcf program);
my @vsm = qw(footprint pcf chebyshev floor reduction format program);

# With two depths the bound is the share that is lit: nothing to blame. The
# receiver is moved by the slack of ties, 1e-6 of the range at most here, at a
# gap of 0.1: p = v / (v + d^2) changes by 2 p (1 - p) / d of that.
my ( $mean, %edge ) = telescopes( 'edge', 5, \@vsm, '--scene', 'edge', @bare );
at_most( $edge{"chain.$_"}{max}, 1e-4, "edge: $_" )
  for qw(chebyshev floor reduction format);
at_most( $edge{'chain.program'}{rmse}, 1e-4, 'edge: program' );
between(
    $mean,
    $edge{hard}{mean} - 1e-7,
    $edge{hard}{mean} + 1e-7,
    'edge: the means add up'
);
my %teapot;
( undef, %teapot ) = telescopes( 'teapot', 5, \@vsm, @small );
between( $teapot{'chain.format'}{max}, 1e-9, 1e-2, 'teapot: fp32: format' );
telescopes( 'central', 5, \@vsm, @small, qw(--moments central) );
telescopes( 'stage', 2, \@pcf, '--scene', 'stage', @small );
telescopes( 'means', 4, [qw(footprint pcf mean format program)], @small );

# The worst bleeding is the bound's, not the code's.
my %bleed = rows_of( dump_run( 5, '--scene', 'bleed:r=4', @bare ) );
between(
    $bleed{'chain.chebyshev'}{max},
    0.98 * 4 / 9,
    1.02 * 4 / 9,
    'bleed, r = 4: chebyshev'
);
at_most( $bleed{'chain.program'}{max}, 1e-3, 'bleed: program' );

# A minimum variance of v lets v / (v + d^2) through where the exact variance
# is 0, all over the shadow of the rectangle at a gap of d.
my %floor =
  rows_of( dump_run( 5, '--scene', 'edge', @bare, qw(--min-variance 0.01) ) );
between( $floor{'chain.floor'}{max}, 0.4999, 0.5001, 'v = d^2: floor' );
at_most( $floor{'chain.chebyshev'}{max}, 1e-4, 'v = d^2: chebyshev' );

# A reduction by A takes A from what was A, and less from the rest.
my %reduced = rows_of(
    dump_run( 5, '--scene', 'edge', @bare, qw(--bleed-reduction 0.3) ) );
between( $reduced{'chain.reduction'}{max}, 0.25, 0.3001, 'A = 0.3' );
at_most( $reduced{'chain.program'}{max}, 1e-3, 'A = 0.3: program' );

# Half floats: their floor and their rounding, each in its place. Storing
# moves a moment by 2^-12 of itself; the floor hides most of that.
my %half =
  rows_of( dump_run( 5, '--scene', 'edge', @bare, qw(--format rg16f) ) );
between( $half{'chain.format'}{max}, 1e-3, 0.2, 'fp16: format' );
at_most( $half{'chain.chebyshev'}{max}, 1e-4, 'fp16: chebyshev' );

# Kept truths: the same answer when they are made, found, spoiled, and where
# there is no place for them.
SKIP: {
    my $dump = dump_run( 5, '--scene', 'edge', @bare );
    my $keep = "$dump/keep";
    mkdir $keep or skip "cannot make $keep: $!", 1;
    my $ask = sub {
        my ( $place, @words ) = @_;
        return ask_oracle( 'errors', $dump, 'rays=16', @words, "keep=$place" )
          ->{out};
    };
    my $made  = $ask->($keep);
    my @files = map { "$keep/$_" } everything_below($keep);
    is( scalar @files, 3,     'kept: pcf, footprint and hard' );
    is( $ask->($keep), $made, 'kept: the same from files' );
    my ($hard) = grep { m{/hard\.} } @files;
    command( 'oiiotool', $hard, '--mulc', '0', '-o', $hard );
    isnt( $ask->($keep), $made, 'kept: it is the files that are read' );
    spew( $_, 'spoiled' ) for @files;
    is( $ask->($keep),          $made, 'kept: made again where spoiled' );
    is( $ask->("$dump/no/way"), $made, 'kept: no place is no matter' );
    $ask->( $keep, 'rays=64' );
    my @more = everything_below($keep);
    is( scalar @more, 4, 'kept: other rays are another footprint' );
}

done_testing;
