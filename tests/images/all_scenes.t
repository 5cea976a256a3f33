# The scenes whose answer is known: what each is there to show. Last come those
# that only rays know.
use strict;
use warnings;
use File::Temp;
use Test::More;
use VSM;

of_steps( 1 .. 5 );

my @small = qw(--size 320x180 --map-size 256);

my $folder = File::Temp->newdir;
my %constant;    # picture by value

sub constant {
    my ($value) = @_;
    my $file = "$folder/$value.exr";
    command( 'oiiotool', '--pattern', "constant:color=$value",
        '320x180', 1, '-d', 'float', '-o', $file )
      if !$constant{$value}++;
    return $file;
}

# In all of them the floor fills the picture, so every pixel counts. The most
# by which one may differ from the value.
sub everywhere {
    my ( $step, $value, $most, @options ) = @_;
    my $dump = dump_run( $step, @small, @options );
    note("step $step @options: visibility is $value");
    oracle( 'compare', "$dump/visibility.exr", constant($value),
        "max=$most" );
    return;
}

# How much darker than 1 the bound can be on a lit plane. Under the filter are t
# and what is as far to both sides of it, so M1 is t but for rounding, 64 units
# of 2^-24 at most, and squared that is nothing next to the variance. But depths
# end at 1. In scene grazing they grow by 0.1205 from a row of texels to the
# next, and no floor is seen beyond t = 0.6501. A part a between two rows, the
# last row under the filter, of weight a / 7, is 4 - a rows away, and cut off by
# 0.6501 + (4 - a) 0.1205 - 1. So M1 is up to 0.0052 too small (a = 0.55), while
# the variance of seven rows is 4 * 0.1205^2, less 0.001 for what is cut off.
my $dark = 0.0052**2 / 0.057;

for my $step ( grep { is_chosen($_) } 5, 1, 2, 3, 4 ) {
    my $most = $step == 5 ? $dark : 0;
    my @bare = $step == 5 ? qw(--bleed-reduction 0) : ();
    everywhere( $step, 1, $most, @bare, '--scene', $_ )
      for qw(grazing empty offstage);
    everywhere( $step, 0, 0, qw(--scene unlit) );
}

# Hard visibility away from outlines.
for my $scene ( grep { is_chosen(1) } qw(thin fence crowd) ) {
    oracle( 'rays', dump_run( 1, @small, '--scene', $scene ) );
}

done_testing;
