# What a program writes, and where to: the picture that was asked for and no
# other.
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

done_testing;
