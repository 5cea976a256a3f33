# Command lines that are wrong as a whole, or whose options contradict each
# other: one line that says so, exit status 2, nothing written.
use strict;
use warnings;

use Draw;
use File::Temp qw(tempdir);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

# Step, arguments, what the line on stderr has to name, the test's name.
my @WRONG = (
    [ 1, ['--nope'],          qr/--nope/,    'an unknown option' ],
    [ 1, ['-x'],              qr/-x/,        'a short option' ],
    [ 5, ['teapot'],          qr/teapot/,    'a word that is no option' ],
    [ 1, [ '--', 'x' ],       qr/'x'/,       'a word after --' ],
    [ 1, ['--bias'],          qr/--bias/,    'an option without its value' ],
    [ 1, ['--list-scenes=1'], qr/--list-sc/, 'a value where none belongs' ],
    [ 1, [ '--scene', "e\nx" ], qr/--scene/, 'a name with a line break' ],

    # Else what a command means would change when an option is added.
    [ 5, [ '--b', '0.5' ], qr/--b'/, 'the beginning of several names' ],

    [ 1, [qw(--kernel 3)],   qr/unknown.*--kernel/, 'an option of step 2' ],
    [ 2, [qw(--blur box)],   qr/unknown.*--blur/,   'an option of step 4' ],
    [ 3, [qw(--radius 3)],   qr/unknown.*--radius/, 'an option of step 4' ],
    [ 4, [qw(--kernel 3)],   qr/unknown.*--kernel/, 'an option of step 2' ],
    [ 5, [qw(--bias 0.001)], qr/unknown.*--bias/,   'an option of step 1' ],

    [ 5, [qw(--map-size 4)], qr/--radius 3.* 0 to 1/, 'too small a map' ],
    [ 4, [qw(--downsample 2 --radius 128)], qr/--radius/, 'too wide a blur' ],
    [ 1, [qw(--scene broken:vertex=2 --show mean)], qr/--show/, 'a word' ],
    [ 4, [qw(--map-size 64x66 --downsample 4)],
        qr/--downsample/, 'a factor that divides one side only' ],
    [ 2, [qw(--pattern poisson --bilinear)],
        qr/--bilinear.*--pattern poisson.*drop one/, 'a disc with a rim' ],
    [ 4, [qw(--blur none --radius 3)],
        qr/--radius.*--blur none/, 'a radius without a blur' ],
    [ 5, [qw(--radius 4 --blur binomial)],
        qr/--radius.*--blur binomial/, 'a radius that the kernel has not' ],
);
for (@WRONG) {
    my ( $step, $arguments, $pattern, $name ) = @$_;
    is_refused( $step, $arguments, [$pattern], $name );
}
my $unblurred = draw( 4, qw(--blur none) );
ok( $unblurred && $unblurred eq draw( 4, qw(--radius 0) ),
    'step 4: no blur is the same as a blur of one texel' );
unlike( run( 1, '--output', '' )->{err},
    qr/from 0 to 0/, 'a text has no range' );

done_testing;
