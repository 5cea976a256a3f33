# The scenes whose answer is known: what each is there to show. Last come those
# that only rays know.
use strict;
use warnings;
use File::Temp;
use Test::More;
use VSM;

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

# How much darker than 1 the bound can be on a lit plane: the depths under the
# filter are t and what is as far to both sides of it, so M1 is t but for
# rounding, with u = 2^-24: 8 u of the lookup, 5 u of its position (4 u of 256
# texels, each 1/220 of the range at most) and 16 u of t, which is made of
# numbers that add up to 3 at most: less than 64 u. The variance is 4 u M2 or
# more, and no floor that is seen lies in the first quarter of the range, so
# 1 - p <= (64 u)^2 / (4 u / 16) = 16384 u.
my $dark = 16384 * 2**-24;

for my $step ( 5, 1, 2, 3, 4 ) {
    my $most = $step == 5 ? $dark : 0;
    my @bare = $step == 5 ? qw(--bleed-reduction 0) : ();
    everywhere( $step, 1, $most, @bare, '--scene', $_ )
      for qw(grazing empty offstage);
    everywhere( $step, 0, 0, qw(--scene unlit) );
}

# Hard visibility away from outlines.
for my $scene (qw(thin fence crowd)) {
    oracle( 'rays', dump_run( 1, @small, '--scene', $scene ) );
}

done_testing;
