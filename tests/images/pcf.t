# Step 2's other filters, and what the bias is for.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 320x180 --map-size 256);

# Every stage from its own input files. Maps finer than the picture, else every
# adaptive filter is as narrow as it may be.
for my $options (
    [qw(--pattern poisson)],
    [qw(--pattern poisson --kernel 31 --map-size 300x180)],
    [qw(--adaptive --kernel 15 --map-size 512)],
    [qw(--adaptive --kernel 31 --map-size 1024 --scene fence --bilinear)],
    [qw(--adaptive --kernel 31 --map-size 1024 --scene fence),
        qw(--pattern poisson)],
    [qw(--adaptive --map-size 512 --scene avenue --splits 2)],
    [qw(--pattern poisson --scene room)],
  )
{
    note("@$options");
    oracle( 'stage', dump_run( 2, @small, @$options ) );
}

# Away from silhouettes every filter gives what one ray does.
oracle( 'rays', dump_run( 2, @small, @$_ ) )
  for [qw(--pattern poisson)], [qw(--adaptive --map-size 512)];

same_files(
    '--adaptive --kernel 1 is step 1',
    dump_run( 1, @small ),
    dump_run( 2, @small, qw(--adaptive --kernel 1) ),
    qw(picture visibility)
);
# 96 texels: the border is the same for both kernels.
my @coarse = qw(--scene edge --size 320x180 --map-size 96);
same_files(
    '--adaptive where pixels are small is 3 texels wide',
    dump_run( 2, @coarse, qw(--kernel 3) ),
    dump_run( 2, @coarse, qw(--adaptive --kernel 5) ),
    qw(picture visibility)
);

# The errors of a dump as {truth}{column}.
sub errors_of {
    my $run = command( root() . '/build/oracle', 'errors', @_ );
    my ( $head, @lines ) = split /\n/, $run->{out};
    my %errors;
    for (@lines) {
        my %row;
        @row{ split /,/, $head } = split /,/;
        $errors{ $row{truth} } = \%row;
    }
    return \%errors;
}

# Of what step 1 draws with this bias, the share of pixels that is wrong.
sub wrong_with {
    my (@arguments) = @_;
    my $dump = dump_run( 1, @small, @arguments );
    return errors_of($dump)->{hard}{share};
}

# Acne: texel centres are as often in front of a lit receiver as behind it, so
# without a bias about half of the lit pixels is dark where texels are larger
# than pixels. Then what the biases leave is silhouettes.
my $acne  = wrong_with(qw(--bias 0 --slope-bias 0));
my $slope = wrong_with();
my $post  = wrong_with(qw(--bias 0.005 --slope-bias 0));
ok( $acne > 0.2,    "no bias: $acne of the pixels wrong" );
ok( $slope < 0.005, "slope bias: $slope wrong" );
ok( $post < $acne / 20,
    "constant bias 0.005: $post wrong, on the steepest slopes" );

# Peter-panning: what lies within the bias behind a caster is lit. The depth
# that a constant covers is the same everywhere, a slope bias covers a texel.
my ( $near, @far ) =
  map { wrong_with( qw(--scene thin), @$_ ) } [],
  map { [ '--bias', $_, '--slope-bias', 0 ] } 0.005, 0.02, 0.05;
ok( $near < $far[0] && $far[0] < $far[1] && $far[1] < $far[2],
    "the larger the constant, the more light at the foot: $near, @far" );
# The strip of light at the foot is as wide as the constant is deep.
my $growth = ( $far[2] - $near ) / ( $far[1] - $near );
ok( abs( $growth / 2.5 - 1 ) < 0.2, "in proportion: $growth for 2.5" );

# A straight edge cuts from the 32 points what it cuts from the disc, but for
# at most 0.083: the largest difference over all edges. A tap reads its texel, up
# to 0.5 / 15 of the disc away, where the disc's area grows by 2 / pi of that.
my $most = 0.084 + 1 / 15 * 2 / 3.14159 * sqrt 2;
my $disc = errors_of(
    dump_run( 2, @small, qw(--scene edge --pattern poisson --kernel 15) ) );
ok( $disc->{footprint}{pixels} > 1000 && $disc->{footprint}{nonfinite} == 0,
    'poisson: footprint truth' );
ok( $disc->{footprint}{p99} < $most,
    "poisson: p99 $disc->{footprint}{p99}, at most $most" );

done_testing;
