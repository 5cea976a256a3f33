# What a program meets and cannot help: no place to write, a full disk, broken
# shaders, an old driver, no memory. It stops with one line that names what is
# wrong, exit status 1, and leaves no partial file behind.
use strict;
use warnings;

use File::Path qw(remove_tree);
use File::Temp qw(tempdir);
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

my @small = qw(--size 16x9);

# A command through sh, which sets limits first: sh -c 'ulimit ...' sh WORDS.
sub with_limit {
    my ( $limit, @words ) = @_;
    return command( '/bin/sh', '-c', "$limit; exec \"\$@\"", 'sh', @words );
}

# --- no place to write ------------------------------------------------------

spew( 'file', 'not a folder' );
mkdir 'folder.png';
for my $path (qw(missing/a.png folder.png /proc/a.png file/a.png)) {
    stops { run( 1, @small, '--output', $path ) } 1,
      [qr/cannot write \Q$path\E: \S/], "--output $path cannot be written";
}
for my $path (qw(missing/dump file file/dump /proc/dump)) {
    stops { run( 1, @small, qw(--output a.png --dump), $path ) } 1,
      [qr/\Q$path\E/], "--dump $path cannot be made";
}
my $long = 'a' x 300 . '.png';
stops { run( 1, @small, '--output', $long ) } 1, [qr/cannot write a+/],
  'a name that is too long for the file system';
for my $step ( 2 .. 5 ) {
    stops { run( $step, @small, '--output', 'missing/a.exr' ) } 1,
      [qr{cannot write missing/a.exr}], "step $step: no place to write";
}
SKIP: {
    skip 'root may write everywhere', 1 if $> == 0;
    mkdir 'locked', 0500;
    stops { run( 1, @small, '--output', 'locked/a.png' ) } 1,
      [qr{cannot write locked/a.png}], 'a folder without write permission';
}

# --- a full disk ------------------------------------------------------------

# A limit on the size of a file breaks off a write in the same way, and needs
# no rights. 512-byte blocks: PNG and EXR get their header out and no more.
my $tiny_files = 'trap "" XFSZ; ulimit -f 1';
my @larger     = qw(--size 320x180);
for my $words (
    [ 1, '--output', 'a.png' ],
    [ 1, '--output', 'a.exr' ],
    [ 1, qw(--output a.png --dump), 'd' ]
  )
{
    my ( $step, @output ) = @$words;
    mkdir 'd';    # may be there afterwards, empty
    stops { with_limit( $tiny_files, program($step), @larger, @output ) } 1,
      [qr/cannot write/], "@output breaks off: no file is left";
}

# A disk of our own, in a mount namespace that ends with the command. Sizes in
# KiB: nothing free, less than a picture, less than the first or second map.
sub on_full_disk {
    my ( $kib, @words ) = @_;
    my $script = <<'END';
mkdir disk && mount -t tmpfs -o size=1m disk disk || exit 99
head -c $((1048576 - $1 * 1024)) /dev/zero >disk/filler; shift
"$@"; status=$?; ls -A disk >listing; exit $status
END
    my $run = command( '/usr/bin/env', qw(unshare -rm sh -c),
        $script, 'sh', $kib, @words );
    my @left = -e 'listing' ? split /\n/, slurp('listing') : ();
    unlink 'listing';
    rmdir 'disk';
    return ( $run, join ' ', grep { $_ ne 'filler' } @left );
}

my ($possible) = on_full_disk( 0, '/bin/true' );
SKIP: {
    skip "no tmpfs can be mounted here: $possible->{err}", 1
      if $possible->{status} || $possible->{signal};
    for my $case (
        [ 0,  qw(--output disk/a.png) ],
        [ 0,  qw(--output disk/a.exr) ],
        [ 4,  qw(--output disk/a.png) ],
        [ 4,  qw(--output disk/a.exr) ],
        [ 64, qw(--output a.png --dump disk) ],
      )
    {
        my ( $kib, @output ) = @$case;
        my $left;
        stops {
            ( my $run, $left ) =
              on_full_disk( $kib, program(1), @larger, @output );
            return $run;
        }
        1, [qr/cannot write disk/], "@output, $kib KiB free: says so";
        is( $left, '', "@output, $kib KiB free: no part of a file is left" );
    }
}

# --- a folder of shaders that is not laid out as the tree -----------------------

spew( 'flat/pcf.glsl', 'float visibility' );
stops { run( 2, @small, qw(--shaders flat --output a.png) ) } 2,
  [qr/--shaders 'flat'.*laid out as the tree/],
  'a shader where nobody looks for it';
remove_tree('flat');

# --- broken shaders ---------------------------------------------------------

# A copy of a shader, changed by a function on its text, below mine/.
sub change_shader {
    my ( $shader, $change ) = @_;
    remove_tree('mine');
    local $_ = slurp( root() . "/$shader" );
    $change->();
    spew( "mine/$shader", $_ );
    return tr/\n//;    # its lines
}

sub draw_with_mine {
    my ($step) = @_;
    return run( $step, @small, qw(--shaders mine --output a.png) );
}

# In each program, one of its own shaders and one of the ground floor. Faults
# of syntax are found by the parser, the others later by the compiler: drivers
# report them in different ways.
my %faults = (
    'a fault of syntax'     => 'float broken() { return ; ; +; }',
    'an undefined function' => 'float broken() { return no_such_thing(1.0); }',
);
my @shaders = (
    [ 1, 'step1_shadowmap/shaders/hard.glsl' ],
    [ 1, 'step1_shadowmap/shaders/map.vert' ],
    [ 2, 'step2_pcf/shaders/pcf.glsl' ],
    [ 3, 'step3_moments/shaders/moments.frag' ],
    [ 4, 'step4_blur/shaders/blur.frag' ],
    [ 5, 'step5_chebyshev/shaders/chebyshev.glsl' ],
    [ 5, 'step1_shadowmap/shaders/scene.frag' ],
);
for my $fault ( sort keys %faults ) {
    for (@shaders) {
        my ( $step, $shader ) = @$_;
        my $line = change_shader( $shader, sub { $_ .= "$faults{$fault}\n" } );
        stops { draw_with_mine($step) } 1, [qr{mine/\Q$shader\E\D{1,2}$line\b}],
          "step $step: $fault in the last line of $shader";
    }
}
my $hard = 'step1_shadowmap/shaders/hard.glsl';
change_shader( $hard, sub { $_ = "@\n$_" } );
stops { draw_with_mine(1) } 1, [qr/\Q$hard\E\D{1,2}1\b/],
  "a fault of syntax in the first line of $hard";

# Faults that only linking finds.
change_shader( $hard, sub { $_ = "float visibility(Receiver receiver);\n" } );
stops { draw_with_mine(1) } 1, [ qr/shader/, qr/visibility/ ],
  'visibility() is promised and not there';
change_shader( 'step1_shadowmap/base/picture/shaders/surface.glsl',
    sub { s/^in vec3 surface_normal/flat in ivec3 surface_normal/m } );
stops { draw_with_mine(1) } 1, [qr/surface_normal/],
  'the two shaders disagree about surface_normal';

# What editors do: a byte order mark in front is no fault; a file that is no
# text is, and is named.
change_shader( $hard, sub { $_ = "\xef\xbb\xbf$_" } );
my $marked = draw_with_mine(1);
is( $marked->{status} . $marked->{err}, '0', 'a byte order mark' );
unlink 'a.png';
change_shader( $hard, sub { s/receiver/rec\0iver/ } );
stops { draw_with_mine(1) } 1, [qr{mine/\Q$hard\E .*no text}], 'a zero byte';

change_shader( $hard, sub { $_ = '' } );
stops { draw_with_mine(1) } 1, [ qr/shader/, qr/visibility/ ], "an empty $hard";
remove_tree('mine');
mkdir $_ for 'mine', 'mine/step1_shadowmap', 'mine/step1_shadowmap/shaders';
mkdir "mine/$hard";
stops { draw_with_mine(1) } 1, [qr/\Q$hard\E/], "a folder called $hard";
remove_tree('mine');

# --- the driver -------------------------------------------------------------

{
    local $ENV{MESA_GL_VERSION_OVERRIDE} = '2.1';
    stops { run( 1, @small, qw(--output a.png) ) } 1, [qr/OpenGL 3\.3/],
      'no OpenGL 3.3';

    # Without the debug messages of 4.3, errors have to be asked for.
    $ENV{MESA_GL_VERSION_OVERRIDE} = '3.3';
    my $run = run( 1, @small, qw(--output a.png) );
    is( $run->{status} . $run->{err}, '0', 'OpenGL 3.3 is enough' );
    unlink 'a.png';
    my $line = change_shader( $hard, sub { $_ .= "float x = no_such;\n" } );
    stops { draw_with_mine(1) } 1, [qr/\Q$hard\E\D{1,2}$line\b/],
      'OpenGL 3.3: a broken shader';
    remove_tree('mine');
}

# A driver that OSMesa has not crashes at the start; one that is led to do what
# it cannot, later, or it offers no context.
for (
    [ GALLIUM_DRIVER             => 'd3d12' ],
    [ GALLIUM_DRIVER             => 'no such' ],
    [ MESA_GLSL_VERSION_OVERRIDE => '120' ],
  )
{
    my ( $name, $value ) = @$_;
    local $ENV{$name} = $value;
    stops { run( 5, @small, qw(--output a.png) ) } 1,
      [qr/unset.* $name\b|OpenGL 3\.3/], "$name=$value: one line";
}
{
    local $ENV{GALLIUM_DRIVER} = 'softpipe';
    my $run = run( 1, @small, qw(--output a.png) );
    is( $run->{status} . $run->{err}, '0', 'another driver that OSMesa has' );
    unlink 'a.png';
}

# --- too large --------------------------------------------------------------

# At most 8 GB, so that a driver that allows this size fails as well.
my $eight = 'ulimit -v 8000000';
SKIP: {
    my $run = with_limit( $eight, program(1), @small, qw(--output a.png) );
    unlink 'a.png';
    skip 'this build reserves more address space than a limit allows', 11
      if $run->{status} || $run->{signal};
    for my $words ( [qw(--size 30000x30000)], [qw(--map-size 30000)] ) {
        stops {
            with_limit( $eight, program(5), @small, @$words,
                qw(--output a.png) )
        }
        2, [qr/$words->[0] .*limit of \d+x\d+/], "@$words is over the limit";
    }
    stops {
        with_limit( $eight, program(1), qw(--size 16384x16384 --output a.png) )
    }
    1, [qr/\S/], 'no memory for --size 16384x16384';

    # What is larger than all that is left is refused before anything else of
    # it is made: the line says how much it is, and how much there is.
    my $two = 'ulimit -v 2000000';
    for my $large (
        [ 4096, qr/16384x16384 texels/, 1, qw(--size 16384x16384) ],
        [ 2048, qr/16384x16384 texels/, 3, @small, qw(--map-size 16384) ],
        [
            3072, qr/4 samples of 8192x8192/,
            3,    @small, qw(--map-size 8192 --msaa), 4
        ],
      )
    {
        my ( $size, $what, $step, @words ) = @$large;
        stops {
            with_limit( $two, program($step), @words, qw(--output a.png) )
        }
        1, [ $what, qr/: $size MiB asked for, 1?\d{1,3} MiB are left$/ ],
          "@words: the size asked for, and what there is";
    }

    # Memory runs out at one place or another: whichever it is, no crash. It
    # starts from the least address space, in MB, that a small picture needs;
    # with this much more, what failed here was the texture, the depth buffer,
    # the pixels read back and their sRGB copy.
    my $least = 600;
    while ( !-e 'a.png' ) {
        $least += 100;
        with_limit( "ulimit -v ${least}000",
            program(1), @small, qw(--output a.png) );
    }
    unlink 'a.png';
    for my $more ( 100, 550, 700, 900 ) {
        my $limit = $least + $more;
        my $large = with_limit( "ulimit -v ${limit}000",
            program(1), qw(--size 4096x4096 --output a.png) );
        my $drawn = -e 'a.png';
        unlink 'a.png';
        ok(
            !$large->{signal} && !$large->{status} == !!$drawn
              && ( $drawn || $large->{err} =~ /\A[^\n]+\n\z/ ),
            "with $limit MB, --size 4096x4096 is drawn or refused in one line"
        ) or diag("signal $large->{signal}: $large->{err}");
    }
    is_deeply( [ grep { /partial/ } everything_below('.') ],
        [], 'no partial file is left' );
}

done_testing;
