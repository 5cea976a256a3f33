# A check that fails says where in the test it stands, and the command to look
# at it by hand, and does not fill the screen.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

my $work = tempdir( CLEANUP => 1 );
my $test = "$work/sample.t";
spew( $test, <<'END' );
use Test::More; use VSM;
sub same { is( $_[0], $_[1], 'the same' ) }
my $dump = dump_run( 5, qw(--scene edge --size 16x9 --map-size 16) );
oracle( 'files', $dump );
oracle( 'compare', "$dump/image.exr", "$dump/normal.exr", 'max=0' );
stops { run( 2, '--size', "it's" ) } 3, [], 'refused';
same( join( "\n", 1 .. 300 ), 'x' x 1e5 );
done_testing;
END
my $told = command( $^X, '-I', root() . '/tests/lib', $test );
my ( undef, @failed ) = split /^# +Failed test /m, $told->{err};
is( scalar @failed, 3, 'what is wrong fails' );
my ( $compare, $refused, $same ) = @failed;
like( $compare, qr/\n.* at \Q$test\E line 5\.\n/, 'the line of a check' );
my ($again) = $compare =~ /by hand: (.*)\n/;
like(
    $again // '',
    qr/ && \S*step5\w+ --scene edge --size 16x9 .* && \S*oracle compare /,
    'its scene, its options and its question'
);
like( $refused, qr/at \Q$test\E line 6\.\n/, 'the line of a refusal' );
like( $refused, qr/by hand: \S*step2_pcf --size 'it'\\''s'\n/, 'quoted' );
like(
    $same,
    qr/at \Q$test\E line 2, called from line 7\.\n/,
    'and of what calls it'
);
cmp_ok( ( $told->{err} =~ tr/\n// ), '<', 60, 'not more than a screen' );
cmp_ok( length $told->{err}, '<', 10_000, 'of lines that can be read' );

# It can be pasted. The oracle's status: something is not as it has to be.
chdir $work or die "cannot work in $work: $!\n";
my $tree = "'" . root() =~ s/'/'\\''/gr . "/'";
my $by_hand = $again =~ s{(?<=&& )(?!/)}{$tree}gr;
is( command( '/bin/sh', '-c', $by_hand )->{status}, 1, 'it fails by hand' );
ok( -e 'out/dump1/image.exr', 'and leaves what to look at' );

done_testing;
