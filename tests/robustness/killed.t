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

# A limit on the size of a file kills a program in the midst of writing one.
my @cut = ( '/bin/sh', '-c', 'ulimit -c 0; ulimit -f 1; exec "$@"', 'sh' );
unlink 'k.exr', '.k.exr.partial';
isnt( command( @cut, @run )->{signal}, 0, 'killed while it writes' );
is_deeply( [ everything_below('.') ],
    ['.k.exr.partial'], 'that leaves a partial file, named after the whole' );
isnt( command( @cut, @run )->{signal}, 0, 'killed again' );
is_deeply( [ everything_below('.') ], ['.k.exr.partial'], 'no second one' );
command(@run);
ok( slurp('k.exr') eq $whole, 'the next run writes the whole' );
is_deeply( [ everything_below('.') ], ['k.exr'], 'and takes the part away' );

# Programs that write the same file at once do not write into one another.
my @same = ( program(1), qw(--size 320x180 --output k.exr) );
command(@same);
my $small = slurp('k.exr');
my @children;
for my $i ( 1 .. 4 ) {
    push @children, my $child = fork // die "cannot fork: $!\n";
    exec { $same[0] } @same if $child == 0;
}
waitpid $_, 0 for @children;
ok( slurp('k.exr') eq $small, 'four programs at once: the file is whole' );
is_deeply( [ everything_below('.') ], ['k.exr'], 'and alone' );
note("killed $before times before the file was there, $after times after");

done_testing;
