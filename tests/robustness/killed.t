# A program that is killed while it writes leaves the old file or the new one,
# never a part of one.
use strict;
use warnings;

use File::Temp  qw(tempdir);
use Test::More;
use Time::HiRes qw(usleep time);
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

my @run = ( program(1), qw(--size 1920x1080 --output k.exr) );
my $start = time;
is( command(@run)->{status}, 0, 'a whole file, to compare with' );
my $duration = time - $start;
my $whole    = slurp('k.exr');

my ( $before, $after ) = ( 0, 0 );
for my $i ( 1 .. 12 ) {
    unlink 'k.exr' if $i % 2;
    spew( 'k.exr', 'old' ) unless $i % 2;
    my $child = fork // die "cannot fork: $!\n";
    if ( $child == 0 ) {
        exec { $run[0] } @run;
    }
    usleep( 1e6 * $duration * ( 0.5 + 0.05 * $i ) );
    kill 'KILL', $child;
    waitpid $child, 0;
    my $found = -e 'k.exr' ? slurp('k.exr') : '';
    my $old   = $i % 2     ? ''             : 'old';
    ok( $found eq $old || $found eq $whole,
        sprintf 'killed after %.0f %% of a run: nothing half written',
        50 + 5 * $i );
    $found eq $whole ? $after++ : $before++;
}
note("killed $before times before the file was there, $after times after");

done_testing;
