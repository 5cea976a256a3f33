# The tests work in folders of their own: what several do at once, or what
# somebody saves meanwhile, is neither taken for theirs nor removed.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

# Another process that makes the same dump and says where, until told to end.
sub another {
    my $child = open( my $from, '-|' ) // die "cannot fork: $!\n";
    return $from if $child;
    $| = 1;
    exec $^X, '-I', root() . '/tests/lib', '-MVSM', '-e',
      'print dump_run( 1, qw(--size 16x9 --map-size 16) ), "\n"; <STDIN>';
}

pipe my $read, my $end or die "no pipe: $!\n";
open STDIN, '<&', $read or die "no standard input: $!\n";
my @others  = map { another() } 1 .. 2;
my @folders = map { scalar readline $_ } @others;
chomp @folders;
isnt( $folders[0], $folders[1], 'two that make the same dump: two folders' );
ok( -s "$_/run.json", 'whole, while both are there' ) for @folders;
close $end;
close $_ for @others;
ok( !-e $_, 'and gone with their process' ) for @folders;

# What somebody saves where a test was started stays and is not held against
# the test; what the test's own command leaves is.
my $tree = tempdir( CLEANUP => 1 );
my $told = command( '/bin/sh', '-c', 'cd "$0" && exec "$@"', $tree, $^X, '-I',
    root() . '/tests/lib', '-MVSM', '-e', <<'END', $tree );
sub refused { run( 1, '--size', 0 ) }
stops { spew( "$ARGV[0]/saved", 'mine' ); refused() } 2, [], 'refused';
stops { spew( 'left', '' ); refused() } 2, [], 'and leaves something';
END
like( $told->{out}, qr/^ok 1 - refused$/m, 'what is saved is not the test\'s' );
is( -e "$tree/saved" && slurp("$tree/saved"), 'mine', 'and stays' );
like( $told->{out}, qr/^not ok 2 /m, 'what a command leaves is found' );
like( $told->{err}, qr/left behind: left$/m, 'and named' );

done_testing;
