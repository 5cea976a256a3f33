# --sampler hardware: within a level of the explicit lookup.
use strict;
use warnings;
use Test::More;
use VSM;

my @bare = qw(--size 80x45 --map-size 1024 --radius 1 --bleed-reduction 0);

for my $options ( [qw(--anisotropy 16)], [], [qw(--scene room --map-size 512)] ) {
    oracle( 'stage',
        dump_run( 5, @bare, qw(--scene fence --mips --sampler hardware),
            @$options ) );
}

done_testing;
