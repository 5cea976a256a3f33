# Any two techniques together: they work, and every pixel is a finite number,
# or they are refused with exit status 2 and one line that names both and says
# what to drop. Which ones are refused is written down here; the others work,
# and because they do, one run tries as many as go together.
use strict;
use warnings;

use File::Spec;
use File::Temp qw(tempdir);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";
my $picture = File::Spec->rel2abs('p.exr');

# Each with what it needs. Later steps have the earlier ones' as well: step 5
# tries them all, the steps before it what they bring.
my @BASE = (
    '--light spot',
    '--light point',
    '--splits 3',
    '--shadows off',
    '--keep-all',
    '--plan',
);
my @BIAS    = ( '--bias 0', '--slope-bias 0' );
my @COMPARE = ( '--kernel 9', '--bilinear', '--pattern poisson', '--adaptive' );
my @MOMENTS = (
    '--format rg16f', '--format auto', '--moments raw', '--moments central',
    '--depth projected', '--slope-term',
    '--slope-term --slope-from derivatives',
    '--msaa 4',
);
my @FILTERS = (
    '--blur none',
    '--blur box',
    '--blur boxes',
    '--blur gaussian',
    '--blur binomial',
    '--radius 2',
    '--downsample 2',
    '--blur-by compute',
    '--blur-by fragments',
    '--mips',
    '--mips --anisotropy 4',
    '--mips --sampler hardware',
    '--sat --sat-by compute',
    '--sat --sat-by fragments',
);
my @BOUND = (
    '--min-variance 1e-4',
    '--variance-bias 1e-3',
    '--bleed-reduction 0.3',
    '--reduction smooth',
    '--deferred',
    '--sat --sat-width adaptive',
    '--soft --light-size 1 --penumbra-scale 2',
    '--soft --hybrid',
);
my %ITEMS = (
    1 => [ @BASE, @BIAS, '--show layer' ],
    2 => [ @BASE, @COMPARE, '--slope-bias 0' ],
    3 => [ @BASE, @MOMENTS, '--show mean' ],
    4 => [ @FILTERS, '--moments central', '--format rg16f' ],
    5 => [ @BASE, @MOMENTS, @FILTERS, @BOUND ],
);

# Whatever matches the one and whatever matches the other. Central moments are
# what contradicts sums only where they were asked for.
my @CONTRADICTIONS = (
    [ qr/--splits/,        qr/--light (spot|point)/ ],
    [ qr/--shadows off/,   qr/--show (mean|variance)/ ],
    [ qr/--bilinear/,      qr/--pattern poisson/ ],
    [ qr/--msaa/,          qr/--slope-from derivatives/ ],
    [ qr/--blur-by/,       qr/--blur none|--sat/ ],
    [ qr/--blur-by compute/, qr/--blur (gaussian|binomial)|--format rg16f/ ],
    [ qr/--radius/,        qr/--blur (none|binomial)/ ],
    [ qr/--sat\b/,         qr/--mips|--blur (?!box$)|--moments central/ ],
    [ qr/--sampler/,       qr/--moments central/ ],
    [ qr/--soft/,          qr/--anisotropy|--sampler|--sat\b|--blur-by/ ],
    [
        qr/--hybrid/,
        qr/--blur (?!none)|--radius|--downsample|--msaa|reduction/
    ],
);

# Of three, where no two contradict each other.
sub is_odd_three {
    my $all = "@_";
    return $all =~ /--sampler hardware/
      && $all =~ /--anisotropy/
      && $all =~ /--light point|--splits/;
}

sub contradict {
    my ( $one, $other ) = @_;
    for (@CONTRADICTIONS) {
        my ( $left, $right ) = @$_;
        return 1 if $one =~ $left  && $other =~ $right;
        return 1 if $one =~ $right && $other =~ $left;
    }
    return 0;
}

# --flag and value of an item, "" for none.
sub options_of {
    my ($item) = @_;
    my %options;
    $options{$1} = $2 // '' while $item =~ /(--[\w-]+)(?: ([^- ]\S*))?/g;
    return %options;
}

# Two values of one option, of which the last would count; or the same with
# something more.
sub is_same_option {
    my %one    = options_of( $_[0] );
    my %other  = options_of( $_[1] );
    my @shared = grep { exists $other{$_} } keys %one;
    return @shared == keys %one || @shared == keys %other
      || grep { $one{$_} ne $other{$_} } @shared;
}

sub words_of {
    my %options = map { options_of($_) } @_;
    return map { $options{$_} eq '' ? $_ : ( $_, $options{$_} ) }
      sort keys %options;
}

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

# Where there are no shadows in the picture, it says nothing about the others.
sub hides {
    my ($item) = @_;
    return $item =~ /--shadows off|--show/;
}

sub goes_with {
    return !contradict(@_) && !is_same_option(@_);
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
