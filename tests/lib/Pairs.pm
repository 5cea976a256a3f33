# Which options go together, as lists of items: an option with its value and
# with what it needs. For the tests that try many at once.
package Pairs;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT = qw(%ITEMS contradict goes_with hides is_odd_three is_same_option
  options_of words_of);

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
    '--format rg16f', '--moments raw', '--moments central',
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
our %ITEMS = (
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

# Where there are no shadows in the picture, it says nothing about the others.
sub hides {
    my ($item) = @_;
    return $item =~ /--shadows off|--show/;
}

sub goes_with {
    return !contradict(@_) && !is_same_option(@_);
}

1;
