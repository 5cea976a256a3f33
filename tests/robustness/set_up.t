# What the set-up says and does, with an apt-get of ours.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

my $work = tempdir( CLEANUP => 1 );
chdir $work or die "cannot work in a temporary folder\n";

# A system that has these commands and nothing else.
mkdir 'bin';
for my $name (qw(sh env awk cat grep ls mktemp rm make mkdir nproc)) {
    my ($path) = grep { -x } map { "$_/$name" } split /:/, $ENV{PATH};
    symlink $path, "bin/$name" or die "no $name\n";
}

sub has {
    my ( $name, $text ) = @_;
    spew( "bin/$name", "#!$work/bin/sh\n$text\n" );
    chmod 0755, "bin/$name";
    return;
}

my $set_up = root() . '/step1_shadowmap/base/set-up.sh';

sub set_up {
    my (@words) = @_;
    local $ENV{PATH}   = "$work/bin";
    local $ENV{TMPDIR} = $work;
    return command( "$work/bin/sh", $set_up, @words );
}
my @wanted = qw(libosmesa6-dev:module:osmesa libx-dev:header:/nowhere/x*.h
  there:command:cat);
my $install =
  'apt-get install -y --no-install-recommends libosmesa6-dev libx-dev';

sub is_one_line {
    my ( $install, $pattern, $name ) = @_;
    stops { set_up( $install, 'the tests', @wanted ) } 1, [$pattern], $name;
    return;
}
my $nothing = set_up( 'yes', 'the tests', 'there:command:cat' );
is( join( '', @$nothing{qw(status out err)} ), '0', 'all is there' );
is_one_line( 'no',  qr/for the tests; as root: $install$/, 'only named' );
is_one_line( 'yes', qr/no apt-get.*: libosmesa6-dev libx-dev$/, 'no Debian' );

# A single folder, and a copy, which bring no packages along.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES STEP DEPS BUILD)};
my $copied = command( qw(bin/make -C), root(), 'standalone', 'STEP=3',
    "DIR=$work/copy" );
is( $copied->{status}, 0, 'a copy' ) or diag( $copied->{err} );
{
    local $ENV{PATH} = "$work/bin";
    for my $folder (qw(copy copy/step3_moments)) {
        my $make  = command( qw(bin/make -C), $folder );
        my @lines = grep { !/^make/ } split /\n/, $make->{err};
        is( scalar @lines, 1, "$folder: one line" ) or diag( $make->{err} );
        like( $lines[0] // '',
            qr/as root: apt-get install .*g\+\+.* libosmesa6-dev/,
            "$folder: names the packages" );
    }
}

# apt-get says $SAYS when it is to do $FAILS, and what it was asked for.
has( 'id',      'echo 0' );
has( 'apt-get', <<'SH');
case $* in
*print-uris*)
    echo "'http://x/a.deb' a.deb 1500000 SHA256:1"
    echo "'http://x/b.deb' b.deb 148600000 SHA256:2"
    exit ;;
esac
echo "Reading package lists..."
echo "$SUDO $DEBIAN_FRONTEND $*" >>asked
[ "${FAILS:-none}" != "$1" ] || { echo "$SAYS"; exit 100; }
SH
has( 'apt-cache', 'case " $GONE " in *" $2 "*) exit 100 ;; esac' );
my $both  = 'libosmesa6-dev libx-dev';
my $fetch = 'E: Failed to fetch http://x/ Could not resolve';
spew( 'asked', '' );
{
    local @ENV{qw(FAILS SAYS GONE)} = ( 'update', $fetch, $both );
    is_one_line( 'yes', qr/network.*$fetch/, 'no network' );
}
{
    local @ENV{qw(FAILS SAYS)} = ( 'install', $fetch );
    my $run = set_up( 'yes', 'the tests', @wanted );
    like( $run->{err}, qr/\A.*network.*$fetch\n\z/, 'the network goes away' );
    $ENV{SAYS} = "E: held\nE: broken";
    $run = set_up( 'yes', 'the tests', @wanted );
    is( $run->{status}, 1, 'an install that fails' );
    like( $run->{err}, qr/^Reading.*\nE: held\nE: broken\nset-up: .*above$/m,
        'shows the log' );
}
{
    local $ENV{GONE} = $both;
    is_one_line( 'yes', qr/no OSMesa.*Debian 12 or 13/, 'OSMesa is gone' );
    $ENV{GONE} = 'libx-dev';
    is_one_line( 'yes', qr/no package libx-dev\b/, 'a package is gone' );
}
{
    local @ENV{qw(FAILS SAYS)} = ( 'update', $fetch );
    my $run = set_up( 'yes', 'the tests', @wanted );
    is( $run->{status} . $run->{err}, 0, 'some other repository fails' );
    is( $run->{out}, 'set-up: for the tests: 2 packages, 150 MB to download, '
          . "about 2 min; running: $install\n", 'sizes come first' );
}

# Not root.
has( 'id', 'echo 1000' );
is_one_line( 'yes', qr/cannot use sudo; as root: $install$/, 'no sudo' );
has( 'sudo', '[ "$1" != -p ] || exit ${REFUSES:-0}
unset DEBIAN_FRONTEND; SUDO=sudo exec "$@"' );
{
    local $ENV{REFUSES} = 1;
    is_one_line( 'yes', qr/cannot use sudo/, 'not for this user' );
}
spew( 'asked', '' );
local $ENV{DEBIAN_FRONTEND} = 'dialog';
set_up( 'yes', 'the tests', @wanted );
my ($words) = $install =~ /^apt-get (.*)/;
like( slurp('asked'), qr/^sudo noninteractive $words -o /m,
    'sudo, and no questions' );
is_deeply( [ glob 'tmp.*' ], [], 'no log is left' );

chdir '/';
done_testing;
