# The tests work in folders of their own: what several do at once, or what
# somebody saves meanwhile, is neither taken for theirs nor removed.
use strict;
use warnings;

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

done_testing;
