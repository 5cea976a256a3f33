# Deferred shading: the same picture from a G-buffer, and a dump that every
# check accepts.
use strict;
use warnings;
use Test::More;
use Same;
use VSM;

my @small = qw(--size 160x90 --map-size 128 --bleed-reduction 0);

# Every check of a forward picture, on what the second pass wrote.
for my $options ( [qw(--scene room)], [qw(--scene avenue --splits 3)] ) {
    my $dump = dump_run( 5, @small, @$options, '--deferred' );
    oracle( $_, $dump ) for qw(files stage matrix rays shading lower);
}
oracle( 'stage', dump_run( 5, @small, qw(--scene fence --deferred),
        qw(--mips --anisotropy 16) ) );

# The G-buffer keeps 32-bit floats, the numbers that the forward shader has. A
# compiler may still order one shader's sums otherwise than the other's: 4e-6
# is 64 roundings of a number of at most 1, a hundredth of what a pixel shows.
for my $options (
    [qw(--scene stage)],
    [qw(--scene room)],
    [qw(--sat --show depth)],
    [qw(--scene fence --mips --map-size 256)],
    [qw(--scene avenue --splits 3 --mips --anisotropy 16)],
  )
{
    my @dumps =
      map { dump_run( 5, @small, @$options, @$_ ) } [], ['--deferred'];
    note("@$options");
    for my $name (qw(image visibility)) {
        oracle( 'compare', ( map { "$_/$name.exr" } @dumps ), 'max=4e-6' );
    }
    same_files( 'the G-buffer', @dumps, qw(position normal) );
}

done_testing;
