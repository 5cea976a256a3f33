# The built-in scenes on the command line: every scene of --list-scenes can be
# drawn, with its keys at both ends of their range and no further.
use strict;
use warnings;

use Draw;
use File::Temp qw(tempdir);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

sub check_list {
    my $run = run( 1, '--list-scenes' );
    is( $run->{status}, 0, '--list-scenes exits with 0' );
    is_deeply( [ everything_below('.') ],
        [], '--list-scenes writes no file' );
    my $scene = '';
    for ( split /\n/, $run->{out} ) {
        if (/^(\w+)  \S/ || /^(every scene)$/) {
            $scene = $1 eq 'every scene' ? 'empty' : $1;
            ok( draw( 1, '--scene', $scene ), "scene $scene is drawn" );
        }
        elsif (/^\s+(\w+)=(\S+)\.\.(\S+) \(default \S+\)  \S/) {
            check_key( "$scene:$1", $2, $3 );
        }
        else {
            fail("--list-scenes prints key, range, default and help: $_");
        }
    }
    ok( $scene, '--list-scenes prints scenes' );
    return;
}

sub check_key {
    my ( $key, $least, $most ) = @_;
    for my $value ( $least, $key eq 'broken:vertex' ? () : $most ) {
        ok( draw( 1, '--scene', "$key=$value" ),
            "scene $key=$value is drawn" );
    }
    my $beyond = $most * 1.1;
    is_refused( 1, [ '--scene', "$key=$beyond" ],
        [ qr/--scene/, qr/from \Q$least\E to \Q$most\E/ ],
        "--scene $key=$beyond" );
    return;
}

check_list();

# Geometry that is not finite is refused, and the object named.
for my $vertex ( 1, 2 ) {
    stops { run( 1, '--scene', "broken:vertex=$vertex", qw(--output a.png) ) }
    1, [ qr/broken/, qr/object 'sail'/, qr/not finite/ ],
      "a vertex that is @{[ $vertex == 1 ? 'no number' : 'infinite' ]}";
}

ok( draw( 1, '--scene', 'bleed:r=4,scale=2,elevation=30' ),
    'several keys at once' );
ok( draw( 1, qw(--scene edge:gap=0.1) ) ne draw( 1, qw(--scene edge:gap=0.3) ),
    'a key changes the picture' );

# Neither a scene nor a key that there is.
my @MISTAKES = (
    'nope', 'Edge', 'edg', 'edge:', 'edge:,', 'edge:nope=1', 'edge:r=2',
    'edge:=1', ':gap=0.1', 'edge:gap=0.1,', 'edge:gap=0.1:scale=2'
);
for my $text (@MISTAKES) {
    is_refused( 1, [ '--scene', $text ],
        [ qr/--scene/, qr/--list-scenes|numbers from/ ], "--scene '$text'" );
}

# A key that there is, with a value that it cannot have.
for my $text ( map { "edge:gap$_" } '', qw(= =x =0.1x =0 =1 =-1 =nan =inf) ) {
    is_refused( 1, [ '--scene', $text ],
        [ qr/--scene/, qr/numbers from 1e-07 to 0\.8/ ], "--scene '$text'" );
}

done_testing;
