# What a program writes, and where to: the picture that was asked for and no
# other, through links and into places that take no second file.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

my $folder = tempdir( CLEANUP => 1 );
chmod 0755, $folder;    # for nobody, below
chdir $folder or die "cannot work in a temporary folder\n";

my @small   = qw(--size 16x9);
my @output  = qw(--output a.png);
my $picture = 'out/' . program_name(5) . '.png';

sub files { return join ' ', grep { !-d } everything_below('.') }

sub clear {
    command( '/bin/sh', '-c', 'rm -rf ./* ./.[!.]*' );
    return;
}

# --- which files ------------------------------------------------------------

# What make draws with --output out/step5.png stays.
mkdir 'out';
spew( 'out/step5.png', 'from make' );
my $run = run( 5, @small );
is( files(), join( ' ', sort 'out/step5.png', $picture ),
    'a run by hand writes a picture of its own' );
is( slurp('out/step5.png'), 'from make', 'and not the one of make' );
is( $run->{out} . $run->{err}, "wrote $picture\n", 'and says so' );
my $right = slurp($picture);
clear();

$run = run( 5, @small, @output );
is( files(), 'a.png', '--output: that file alone' );
is( $run->{out} . $run->{err}, "wrote a.png\n", '--output: it is named' );
clear();

for my $other ( ['--plan'], [qw(--bench 1 --redraw)] ) {
    $run = run( 5, @small, @$other );
    is( files() . $run->{err}, '', "@$other: no picture" );
    ok( !-e 'out', "@$other: nor a folder for it" );
    $run = run( 5, @small, @$other, @output );
    is( files(),     'a.png',         "@$other: the picture of --output" );
    is( $run->{err}, "wrote a.png\n", "@$other: named apart from the data" );
    unlike( $run->{out}, qr/wrote/, "@$other: which is alone on stdout" );
    clear();
}
$run = run( 5, @small, qw(--dump d) );
ok( -e 'd/image.exr' && !-e 'out', '--dump: no picture but the one in it' );
is( $run->{out} . $run->{err}, "wrote d/\n", '--dump: the folder is named' );
$run = run( 5, @small, @output, qw(--dump d) );
is( $run->{out}, "wrote a.png\nwrote d/\n", '--dump and --output: both' );
clear();

# --- through links ----------------------------------------------------------

# Draws a.png; whether it went well and the file of this name is the picture.
sub draws {
    my ( $file, $name ) = @_;
    my $drawn = run( 5, @small, @output );
    return is( $drawn->{status} . $drawn->{err} . slurp($file),
        "0$right", $name );
}

spew( 'there/b.png', 'old' );
chmod 0640, 'there/b.png';
symlink 'there/b.png', 'a.png';
draws( 'there/b.png', 'a link: what it points to is written' );
ok( -l 'a.png', 'a link: it stays one' );
is( ( stat 'there/b.png' )[2] & 07777, 0640, 'the permissions stay' );
clear();

mkdir 'there';
symlink 'there/b.png', 'a.png';
draws( 'there/b.png', 'a link to nothing: the file is made' );
ok( -l 'a.png', 'a link to nothing: it stays one' );
clear();

spew( 'a.png', 'old' );
link 'a.png', 'b.png';
draws( 'a.png', 'another name of the same file' );
is( slurp('b.png'), 'old', 'keeps what it was' );
clear();

# The reader ends when the program closes the pipe.
command(qw(mkfifo a.png));
$run = command( '/bin/sh', '-c', 'cat a.png >b.png & "$@" && wait',
    'sh', program(5), @small, @output );
is( slurp('b.png'), $right, 'a pipe is written into' );
ok( -p 'a.png', 'and stays one' );
clear();

# --- where no second file can be --------------------------------------------

# Root may write anywhere: such a program is nobody's.
sub run_as_nobody {
    my @words = @_;
    return $> ? command(@words) : command( $^X, '-e',
        '$) = $( = 65534; $< = $> = 65534; exec { $ARGV[0] } @ARGV; exit 127',
        @words
    );
}

SKIP: {
    run_as_nobody( program(5), '--help' )->{status} == 0
      or skip 'nobody may not read the programs', 5;
    my @run = ( program(5), @small );
    mkdir 'locked';
    spew( 'locked/a.png', 'old, and longer than a picture' x 999 );
    chmod 0666, 'locked/a.png';
    chmod 0555, 'locked';
    $run = run_as_nobody( @run, qw(--output locked/a.png) );
    is( $run->{err}, '', 'a file that may be written, in a folder that not' );
    ok( slurp('locked/a.png') eq $right, 'is written' );
    stops { run_as_nobody( @run, qw(--output locked/b.png) ) } 1,
      [qr{cannot write locked/b.png: Permission denied}], 'another one is not';

    mkdir 'open';
    chmod 0777, 'open';
    spew( 'open/a.png', 'kept' );
    chmod 0444, 'open/a.png';
    stops { run_as_nobody( @run, qw(--output open/a.png) ) } 1,
      [qr{cannot write open/a.png: Permission denied}],
      'a file that may not be written, in a folder that may';
    is( slurp('open/a.png'), 'kept', 'is kept' );
    chmod 0755, 'locked';
    clear();
}

# A file of its own on which another is mounted: it cannot be replaced.
my $script = 'mount --bind b.png a.png || exit 99; "$@"';
spew( $_, 'old' ) for 'a.png', 'b.png';
$run = command( '/usr/bin/env', qw(unshare -rm sh -c),
    $script, 'sh', program(5), @small, @output );
SKIP: {
    skip 'nothing can be mounted here', 2 if $run->{out} !~ /wrote/;
    is( slurp('b.png'), $right, 'a mounted file is written' );
    is( files(), 'a.png b.png', 'and nothing else is left' );
}
clear();

# A name that leaves no room for a longer one.
my $long = 'a' x 251 . '.png';
run( 5, @small, '--output', $long );
is( files(), $long, 'the longest name that there can be' );

done_testing;
