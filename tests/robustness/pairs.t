# Any two techniques together: they work, and every pixel is a finite number,
# or they are refused with exit status 2 and one line that names both and says
# what to drop. Which ones are refused is written down here; the others work,
# and because they do, one run tries as many as go together.
use strict;
use warnings;

use File::Spec;
use File::Temp qw(tempdir);
use Test::More;
use Pairs;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";
my $picture = File::Spec->rel2abs('p.exr');

sub small_run {
    my ( $step, @words ) = @_;
    return run_warm( $step, qw(--size 32x18 --map-size 16 --output p.exr), @words );
}

sub refuses {
    my ( $step, @pair ) = @_;
    my @names = map {
        my %options = options_of($_);
        my $any     = join '|', keys %options;
        qr/(?:$any)\b/
    } @pair;
    return stops { small_run( $step, words_of(@pair) ) }
    2, [ @names, qr/\bdrop\b/ ], "step $step: @pair: refused";
}

sub works {
    my ( $step, @items ) = @_;
    my $name = "step $step: @items: finite";
    my $run  = small_run( $step, words_of(@items) );
    return fail($name) && diag("status $run->{status}: $run->{err}")
      if $run->{status} || $run->{signal} || !-e $picture;
    my $answer = ask_oracle( 'compare', $picture, $picture );
    unlink $picture;
    return ok( !$answer->{status}, $name ) || diag( $answer->{out} );
}

# Greedily: a set starts with a pair that was not in any set, and takes what
# brings most such pairs as long as there is anything.
sub next_set {
    my ( $open, @items ) = @_;
    my ($first) = sort keys %$open;
    my @set = split /;/, $first;
    while (1) {
        my ( $best, $most ) = ( undef, 0 );
        for my $item (@items) {
            next if grep { $_ eq $item || !goes_with( $_, $item ) } @set;
            next if is_odd_three( @set, $item );
            next if hides($item) && !hides($first);
            my $new = grep { $open->{ pair( $_, $item ) } } @set;
            ( $best, $most ) = ( $item, $new ) if $new > $most;
        }
        last unless defined $best;
        push @set, $best;
    }
    my @hiding = grep { hides($_) } @set;
    for my $one ( @hiding ? @hiding : @set ) {
        delete $open->{ pair( $one, $_ ) } for @set;
    }
    return @set;
}

sub pair { return join ';', sort @_ }

for my $step ( sort keys %ITEMS ) {
    my @items = @{ $ITEMS{$step} };
    my %open;
    for my $i ( 0 .. $#items ) {
        for ( 0 .. $i - 1 ) {
            my @pair = @items[ $_, $i ];
            next if is_same_option(@pair);
            contradict(@pair)
              ? refuses( $step, @pair )
              : ( $open{ pair(@pair) } = 1 );
        }
    }
    works( $step, next_set( \%open, @items ) ) while %open;
}

done_testing;
