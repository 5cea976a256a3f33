# The window, on a display of its own: it shows what is drawn off-screen, obeys
# the mouse and the keys, and outlives an error in a shader.
use strict;
use warnings;

use File::Temp  qw(tempdir);
use POSIX       ();
use Test::More;
use Time::HiRes qw(sleep time);
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

# The GL driver for X leaks 112 bytes and is unloaded before the sanitizer could
# say whose they are. What the programs share with off-screen runs is checked
# for leaks there.
$ENV{ASAN_OPTIONS} //= 'detect_leaks=0' if $ENV{VSM_SLOW};

my $SECONDS = $ENV{VSM_PATIENCE} // 300;    # to wait for anything
my @CLOSE   = qw(max=0.004 share=0.001);    # rounding to 8 bits may differ

# What the title says of each step's main parameter, and a shader of the step
# with a word whose loss it cannot compile without.
my %STEPS = (
    1 => [ 'map 512x512',  'step1_shadowmap/shaders/hard.glsl', 'texel' ],
    2 => [ 'kernel 7',     'step2_pcf/shaders/pcf.glsl',        'radius' ],
    3 => [ 'map 512x512', 'step3_moments/shaders/moments.frag', 'depth' ],
    4 => [ 'radius 3',     'step4_blur/shaders/blur.frag',      'weights' ],
    5 => [ 'radius 3', 'step5_chebyshev/shaders/chebyshev.glsl', 'variance' ],
);

my ( $server, $server_pid, %children );
local $SIG{INT} = local $SIG{TERM} = sub { exit 1 };    # past END

END {
    local $?;
    kill 'KILL', keys %children;
    if ($server_pid) {
        kill 'TERM', $server_pid;
        close $server;    # waits for it
    }
}

# A display that nobody else uses: the server picks its number.
sub start_display {
    $server_pid = open( $server, '-|' ) // die "cannot fork: $!\n";
    if ( $server_pid == 0 ) {
        open STDERR, '>', '/dev/null';

        # Else it starts afresh, deaf meanwhile, when a window has closed.
        exec(qw(Xvfb -displayfd 1 -noreset -screen 0 800x600x24))
          or POSIX::_exit(127);
    }
    my $number = <$server> // die "Xvfb does not start\n";
    chomp $number;
    $ENV{DISPLAY} = ":$number";
    delete $ENV{WAYLAND_DISPLAY};
    return;
}

# Whether the code returns something true before the time is over.
sub soon(&) {
    my ($code) = @_;
    my $end = time + $SECONDS;
    until ( $code->() ) {
        return 0 if time > $end;
        sleep 0.02;
    }
    return 1;
}

# Opens a step in a window and waits until it shows a picture. Returns {pid,
# id}; what the program prints goes to the files stdout and stderr.
sub open_window {
    my ( $step, @arguments ) = @_;
    Failing::is_about( program($step), '--window', @arguments );
    my $pid = fork // die "cannot fork: $!\n";
    if ( $pid == 0 ) {
        open STDOUT, '>', 'stdout';
        open STDERR, '>', 'stderr';
        alarm 10 * $SECONDS;    # goes on across exec
        exec( program($step), '--window', @arguments ) or POSIX::_exit(127);
    }
    $children{$pid} = 1;
    my $window = { pid => $pid, id => '' };
    my $open   = soon {
        my $found = command( qw(xdotool search --pid), $pid )->{out};
        ( $window->{id} ) = $found =~ /^(\d+)$/m;
        $window->{id} && title($window) =~ / ms$/;
    };
    die "step $step does not open a window: " . slurp('stderr') if !$open;
    command( qw(xdotool windowfocus --sync), $window->{id} );
    return $window;
}

# Waits until the window has closed; returns the program's exit status.
sub closed {
    my ($window) = @_;
    soon { waitpid( $window->{pid}, POSIX::WNOHANG ) } or return 'still open';
    delete $children{ $window->{pid} };
    return $?;
}

sub title {
    my ($window) = @_;
    my $title = command( qw(xdotool getwindowname), $window->{id} )->{out};
    chomp $title;
    return $title;
}

# The window's pixels, in a format that holds nothing else.
sub screenshot {
    my ( $window, $file ) = @_;
    $file //= 'now.ppm';
    command( qw(import -depth 8 -window), $window->{id}, "ppm:$file" );
    return -e $file ? slurp($file) : '';
}

sub press { return command( qw(xdotool key), @_ ) }

# The picture after all that was pressed and moved before. `h` is answered once
# everything before it was heard, and a second time once that is drawn; and what
# is drawn is there when two looks see the same.
sub picture {
    my ( $window, @file ) = @_;
    for ( 1, 2 ) {
        my $told = -s 'stdout';
        press('h');
        soon { -s 'stdout' > $told } or die "h prints nothing\n";
    }
    my ( $before, $now ) = '';
    soon {
        ( $before, $now ) = ( $now // '', screenshot( $window, @file ) );
        $now ne '' && $now eq $before;
    } or die "the window is never the same twice\n";
    return $now;
}

# One step: the off-screen picture; a wrong shader; the right one again.
sub check_step {
    my ($step) = @_;
    my ( $parameter, $shader, $word ) = @{ $STEPS{$step} };
    my @size = qw(--size 320x180);
    run( $step, @size, '--output', 'offscreen.png' );
    my $text = slurp( root() . "/$shader" );
    spew( "mine/$shader", $text );
    my $window = open_window( $step, @size, qw(--shaders mine) );
    like( title($window), qr/^teapot - step $step, $parameter - [\d.]+ ms$/,
        "step $step: the title" );
    my $first = picture( $window, 'first.ppm' );
    oracle( 'compare', 'offscreen.png', 'first.ppm', @CLOSE );

    my ($before) = $text =~ /(.*)\b$word\b/s or die "no $word in $shader\n";
    my $line = 1 + ( $before =~ tr/\n// );
    spew( "mine/$shader", $text =~ s/\Q$before\E\K$word/${word}s/r );
    press('r');
    ok( soon { title($window) =~ /shader error$/ },
        "step $step: a wrong shader is in the title" );
    my $place = qr{shader mine/\Q$shader\E:$line\b};
    like( slurp('stderr'), qr/\A\w+: $place[^\n]*error[^\n]*\n\z/,
        "step $step: one line names the file that was read, and its line" );
    ok( picture($window) eq $first, "step $step: the old picture stays" );

    spew( "mine/$shader", "$text\n" );
    press('r');
    ok( soon { title($window) =~ / ms$/ },
        "step $step: the right shader is taken" );
    ok( picture($window) eq $first,
        "step $step: and draws the same picture" );
    return ( $window, $first );
}

# The shader of a pass that no picture needed yet is broken, and then it may be
# needed: the window says so and stays.
sub check_unused {
    my $shader = 'step1_shadowmap/shaders/map.vert';
    spew( "mine/$shader", slurp( root() . "/$shader" ) );
    my $window = open_window( 5,
        qw(--scene unlit --size 160x90 --map-size 64 --shaders mine) );
    spew( "mine/$shader", 'broken' );
    press('r');
    ok( soon { title($window) =~ /shader error$/ },
        'a wrong shader that no picture needed yet' );
    press('Right');
    press('Escape');
    is( closed($window), 0, 'does not close the window' );
    return;
}

# Presses a key after `before`; it has to print the keys, once.
sub helps {
    my ( $name, $key, @before ) = @_;
    my $length = length slurp('stdout');
    command(@before) if @before;
    press($key);
    ok( soon { length slurp('stdout') > $length }, "h prints the keys, $name" );
    sleep 0.05;
    my $keys = substr slurp('stdout'), $length;
    like( $keys, qr/\A(?!.*escape.*escape).*arrow.*\br .*\bs .*\bh .*escape/s,
        "all of them once, $name" );
    return;
}

# Where the letters are elsewhere, or are others. 43 is the key of an American
# h, whose letter a French keyboard has in the same place; Dvorak's is at 44.
sub check_letters {
    helps( 'alone',          'h' );
    helps( 'with shift',     'shift+h' );
    helps( 'with caps lock', 'h', qw(xdotool key Caps_Lock) );
    press('Caps_Lock');
    helps( "on a keyboard of $_->[0]", $_->[1], 'setxkbmap', $_->[0] )
      for [ru => 43], [gr => 43], [il => 43], [fr => 43], ['us(dvorak)', 44];
    command(qw(setxkbmap us));
    return;
}

# What the window shows when it has another shape: the picture as it is in the
# middle, or smaller, and nothing beside it.
sub check_shape {
    my ( $window, $first ) = @_;
    for ( [ '320x240', '+0+30' ], [ '480x180', '+80+0' ] ) {
        my ( $size, $corner ) = @$_;
        command( qw(xdotool windowsize --sync), $window->{id}, split /x/, $size );
        my $inside = sub {
            screenshot( $window, 'large.ppm' );
            command( qw(convert large.ppm -crop), "320x180$corner", '+repage',
                'ppm:inside.ppm' );
            return -e 'inside.ppm' && slurp('inside.ppm') eq $first;
        };
        ok( soon { $inside->() }, "$size: the picture is in the middle" );
        command( qw(convert large.ppm -fill black -draw),
            'rectangle ' . ( $size =~ /^320/ ? '0,30 319,209' : '80,0 399,179' ),
            'ppm:beside.ppm' );
        unlike( slurp('beside.ppm'), qr/\AP6\s\d+\s\d+\s\d+\s.*[^\0]/s,
            "$size: and nothing beside it" );
    }
    command( qw(xdotool windowsize --sync), $window->{id}, 160, 180 );
    ok( soon { screenshot($window) =~ /\AP6\s160 180\s255\s\0{21600}[^\0]/ },
        '160x180: half as large, with nothing above it' );
    command( qw(xdotool windowsize --sync), $window->{id}, 320, 180 );
    ok( picture($window) eq $first, 'and as it was' );
    return;
}

sub check_keys {
    my ( $window, $first ) = @_;
    press('s');
    ok( soon { -e 'saved.png' }, 's saves the picture' )
      and oracle( 'compare', 'offscreen.png', 'saved.png', @CLOSE );

    my @opposite = qw(Right Left Up Down plus minus);
    while ( my ( $there, $back ) = splice @opposite, 0, 2 ) {
        press($there);
        my $moved = picture($window);
        ok( $moved ne $first, "$there moves the camera" );
        press($back);
        ok( picture( $window, 'back.ppm' ) ne $moved, "$back moves it" );
        oracle( 'compare', 'first.ppm', 'back.ppm', @CLOSE );
    }
    return;
}

sub check_mouse {
    my ($window) = @_;
    my $still = picture($window);
    command(qw(xdotool mousemove 100 100 mousemove 150 120));
    ok( picture($window) eq $still, 'the pointer alone does nothing' );
    command(qw(xdotool mousedown 1 mousemove 200 110 mouseup 1));
    my $dragged = picture($window);
    ok( $dragged ne $still, 'a drag moves the camera' );
    command(qw(xdotool click 4));
    ok( picture($window) ne $dragged, 'the wheel moves the camera' );
    return;
}

# A shader that compiles and draws something else is taken, too.
sub check_edit {
    my ($window) = @_;
    my $shader = 'step1_shadowmap/shaders/scene.frag';
    my $text   = slurp( root() . "/$shader" );
    my $before = picture($window);
    spew( "mine/$shader", $text =~ s/= albedo \*/= albedo.bgr */r );
    press('r');
    ok( picture($window) ne $before, 'an edited shader shows' );
    spew( "mine/$shader", $text );
    press('r');
    ok( picture($window) eq $before, 'and the old one again' );
    return;
}

{
    local %ENV = %ENV;
    delete @ENV{qw(DISPLAY WAYLAND_DISPLAY)};
    stops { run( 5, qw(--window --output a.png) ) } 1,
      [qr/no display: --window needs one/], 'no display: one line';
    is( run( 5, qw(--size 16x9 --output a.png) )->{status},
        0, 'without a window no display is needed' );
    unlink 'a.png';
}
for ( [qw(--dump dump)], [qw(--bench 2)] ) {
    stops { run( 1, qw(--window --output a.png), @$_ ) } 2,
      [ qr/--window/, qr/drop $_->[0]/ ], "no window with $_->[0]";
}

start_display();

# The connection to the display would take stdout's place.
stops {
    command( '/bin/sh', '-c', 'exec "$@" >&-', 'sh', program(1),
        qw(--window --output a.png) )
}
1, [qr/cannot write to stdout: Bad file/], 'a window without a stdout';
for my $step ( 1 .. 5 ) {
    my ( $window, $first ) = check_step($step);
    if ( $step == 5 ) {
        check_edit($window);
    }
    press('Escape');
    is( closed($window), 0, "step $step: escape closes the window" );
}
check_unused();
run( 5, qw(--size 320x180 --output offscreen.png) );
my $window = open_window( 5, qw(--size 320x180 --output saved.png) );
is( slurp('stdout'), "h prints what the keys do in the window\n",
    'h is named at the start' );
check_letters();
my $first = picture( $window, 'first.ppm' );
check_shape( $window, $first );
check_keys( $window, $first );
check_mouse($window);
press('Escape');
is( closed($window), 0, 'escape closes the window' );
is( slurp('stderr'), '', 'nothing was wrong' );

done_testing;
