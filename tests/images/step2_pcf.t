# Step 2's other filters.
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

# A straight edge cuts from the 32 points what it cuts from the disc, but for
# at most 0.083: the largest difference over all edges. A tap reads its texel, up
# to 0.5 / 15 of the disc away, where the disc's area grows by 2 / pi of that.
my $most = 0.084 + 1 / 15 * 2 / 3.14159 * sqrt 2;
my $dump = dump_run( 2, @small, qw(--scene edge --pattern poisson --kernel 15) );
my $table = ask_oracle( 'errors', $dump )->{out};
my ($p99) = $table =~ /^footprint,\d{4,},\d+,0,[^,]+,([^,]+),/m;
ok( defined $p99 && $p99 < $most, "poisson: p99 " . ( $p99 // $table ) );

done_testing;
