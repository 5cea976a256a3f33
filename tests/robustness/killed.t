# A program that is killed while it writes leaves the old file or the new one,
# never a part of one.
use strict;
use warnings;

use File::Temp qw(tempdir);
use List::Util qw(max);
use POSIX      qw(WNOHANG);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

my @run = ( program(1), qw(--size 1920x1080 --output k.exr) );
is( command(@run)->{status}, 0, 'a whole file, to compare with' );
my $whole = slurp('k.exr');

# How much of it is there, under whatever name.
sub written { return max 0, map { -s $_ // 0 } everything_below('.') }

my ( $before, $after ) = ( 0, 0 );
for my $i ( 1 .. 12 ) {
    unlink 'k.exr' if $i % 2;
    spew( 'k.exr', 'old' ) unless $i % 2;
    my $child = fork // die "cannot fork: $!\n";
    if ( $child == 0 ) {
        exec { $run[0] } @run;
    }
    1 until written() >= $i / 12 * length $whole
      || ( my $ended = waitpid $child, WNOHANG );
    kill 'KILL', $child and waitpid $child, 0 if !$ended;
    my $found = -e 'k.exr' ? slurp('k.exr') : '';
    my $old   = $i % 2     ? ''             : 'old';
    ok( $found eq $old || $found eq $whole,
        "killed after $i twelfths of the file: nothing half written" );
    $found eq $whole ? $after++ : $before++;
}
note("killed $before times before the file was there, $after times after");

done_testing;
