# `make grade` against submissions that mean harm: nothing outside their own
# grade/ is created or changed, no process outlives it, memory and time have an
# end, and every function gets its own mark.
use strict;
use warnings;

use Digest::SHA qw(sha1_hex);
use File::Path  qw(make_path);
use File::Temp  qw(tempdir);
use FindBin;
use IO::Socket::UNIX;
use lib "$FindBin::Bin/../exercise";
use POSIX qw(WNOHANG mkfifo);
use Test::More;
use Time::HiRes qw(sleep time);
use Submission;
use Tasks;
use VSM;

my $work    = tempdir( CLEANUP => 1 );
my $SECONDS     = $ENV{VSM_SLOW} ? 50 : 5;    # until an endless run is stopped
my $PATIENCE    = 200;                          # with other runs
my @small       = qw(--size 160x90 --map-size 128);
my $MARKER      = "grade.t $$";                 # in the environment
my $MOST_MEMORY = 1e9;

# grade.pl on small pictures, with runs of so many seconds.
sub grade {
    my ( $seconds, @words ) = @_;
    my @paths = map { '-I' . root() . "/tests/$_" } qw(lib exercise);
    my $set   = "\$VSM::SECONDS = $seconds; \@Marks::SIZE = qw(@small); "
      . 'my $script = shift; do $script or die $@ || $!';
    return (
        $^X, @paths, qw(-MVSM -MMarks -e),
        $set, root() . '/tests/exercise/grade.pl', @words
    );
}

# The processes that were started here, directly or not, and are still there.
sub alive {
    my @alive;
    for my $process ( grep { /^\d+$/ } map { s{.*/}{}r } glob '/proc/*' ) {
        my $words = eval { slurp("/proc/$process/environ") } // next;
        push @alive, $process
          if index( "\0$words", "\0VSM_MARKER=$MARKER\0" ) >= 0;
    }
    return @alive;
}

sub resident {
    my $status = join '', map { eval { slurp("/proc/$_/status") } // '' } @_;
    my $kib    = 0;
    $kib += $1 while $status =~ /^VmRSS:\s*(\d+)/mg;
    return 1024 * $kib;
}

# Every file, link and folder below a folder, but for one submission's grade/.
sub state_of {
    my ( $folder, $but ) = @_;
    my %state;
    for my $path ( everything_below($folder) ) {
        next if $path =~ m{^\Q$but\E/grade(?:/|$)};
        my @facts = lstat "$folder/$path";
        my $read  = -f _ && -s _ < 1e6;
        $state{$path} = join ' ', $facts[2], -d _ ? () : @facts[ 3, 7 ],
          -l _    ? readlink "$folder/$path"
          : $read ? sha1_hex( slurp("$folder/$path") )
          :         '';
    }
    return \%state;
}

# Starts the marking, with temporary files of its own below $work/tmp.
sub start {
    my ( $name, $seconds ) = @_;
    make_path("$work/tmp");
    my $child = fork // die "cannot fork: $!\n";
    return $child if $child;
    @ENV{qw(VSM_MARKER TMPDIR)} = ( $MARKER, "$work/tmp" );
    chdir "$work/class" or POSIX::_exit(126);
    open STDOUT, '>', "$work/$name.out";
    open STDERR, '>', "$work/$name.err";
    open STDIN,  '<', '/dev/null';
    exec grade( $seconds, 5, $name ) or POSIX::_exit(127);
}

# Marks a submission and returns what was printed. Tests what no submission may
# do.
sub graded {
    my ( $name, $seconds ) = @_;
    my $before = state_of( "$work/class", $name );
    my $start  = time;
    my $child  = start( $name, $seconds );
    my $most   = 0;
    while ( waitpid( $child, WNOHANG ) == 0 ) {
        my $now = resident( alive() );
        $most = $now if $now > $most;
        kill 'KILL', $child if time > $start + $PATIENCE;
        sleep 0.1;
    }
    my $status = $?;
    my $took   = time - $start;
    my $said   = slurp("$work/$name.out") . slurp("$work/$name.err");
    is( $status >> 8, 1, "$name: exit status 1" ) or diag($said);
    is_deeply( state_of( "$work/class", $name ),
        $before, "$name: nothing else is changed" );
    cmp_ok( $most, '<', $MOST_MEMORY, "$name: memory" ) unless $ENV{VSM_SLOW};
    cmp_ok( $took, '<', $PATIENCE, "$name: time" );
    is( join( ' ', alive() ), '', "$name: no process is left" );
    is( join( ' ', everything_below("$work/tmp") ),
        '', "$name: no temporary file is left" );
    unlike( $said, qr/[^\n\x20-\x7e]/, "$name: plain letters" );
    cmp_ok( length $said, '<', 3000, "$name: and not many" );
    return $said;
}

# A submission, right but for these texts of files of its shaders/.
sub submission {
    my ( $name, $step, %texts ) = @_;
    my $folder  = "$work/class/$name";
    my $shaders = program_name($step) . '/shaders';
    for my $task ( tasks($step) ) {
        my $file = task_file( $step, $task );
        spew( "$folder/$file", slurp( root() . "/$file" ) );
    }
    for my $file ( keys %texts ) {
        unlink "$folder/$shaders/$file";
        spew( "$folder/$shaders/$file", $texts{$file} )
          if defined $texts{$file};
    }
    return "$folder/$shaders";
}

my ( $CHEBYSHEV, $REDUCTION, $VISIBILITY ) =
  qw(chebyshev.glsl reduction_linear.glsl visibility.glsl);
my %heading = map { $_->{file} => $_->{function} } tasks(5);

sub body {
    my ( $file, $body ) = @_;
    return "$heading{$file}\n{\n$body\n}\n";
}
my $precious = "$work/class/precious";
spew( "$precious/$_", "mine\n" )
  for qw(file shaders/chebyshev.glsl chebyshev.png);

# No plain files.
my $shaders = submission( 'pipe', 5, $CHEBYSHEV => undef, $REDUCTION => undef );
mkfifo( "$shaders/$CHEBYSHEV", oct 600 ) or die "no pipe: $!\n";
make_path("$shaders/$REDUCTION");
symlink "$precious/file", "$work/class/pipe/Makefile";
mkfifo( "$work/class/pipe/step5_chebyshev/main.c", oct 600 );
my $said = graded( 'pipe', $PATIENCE );
like( $said, qr/^wrong  .*$CHEBYSHEV\n +it is no plain file/m,     'a pipe' );
like( $said, qr/^wrong  .*$REDUCTION\n +it is no plain file/m,     'a folder' );
like( $said, qr/^right  .*$VISIBILITY\n/m, 'the other' );
like( $said, qr{not looked at: Makefile step5_chebyshev/main\.c$}m, 'named' );

$shaders = submission( 'huge', 5, $CHEBYSHEV => '', $VISIBILITY => undef,
    $REDUCTION => body( $REDUCTION, 'return p_max;' ) . "\0}}}" );
truncate "$shaders/$CHEBYSHEV", 1e12 or diag("no large file: $!");
my $socket = IO::Socket::UNIX->new( Local => "$shaders/$VISIBILITY" )
  or diag("no socket: $!");
$said = graded( 'huge', $PATIENCE );
like( $said, qr/^wrong  .*$CHEBYSHEV\n +it is over 16383 bytes/m, 'a TB' );
like( $said, qr/^wrong  .*$REDUCTION\n +It holds a byte 0/m,      'a byte 0' );
like( $said, qr/^wrong  .*$VISIBILITY\n +(?:it is no plain|missing)/m,
    'a socket' );

# Links: a file, a folder on the way, grade/ and a picture.
my %missing = map { $_ => undef } $CHEBYSHEV, $REDUCTION, $VISIBILITY;
$shaders = submission( 'link', 5, %missing,
    $REDUCTION => body( $REDUCTION, 'return p_max;' ) );
symlink "$precious/file", "$shaders/$CHEBYSHEV";
symlink $precious, "$work/class/link/grade";
$said = graded( 'link', $PATIENCE );
like( $said, qr/^wrong  .*$CHEBYSHEV\n +it is no plain file/m, 'a link' );
like( $said, qr/no picture: grade is no folder/, 'grade/ is a link' );

submission( 'folder', 5, %missing );
rename "$work/class/folder/step5_chebyshev", "$work/class/folder/moved";
symlink $precious, "$work/class/folder/step5_chebyshev";
$said = graded( 'folder', $PATIENCE );
like( $said, qr/step5_chebyshev is no folder that can be read, or a link/,
    'a link on the way' );

submission( 'picture', 5, %missing,
    $CHEBYSHEV => body( $CHEBYSHEV, 'return 1.0;' ) );
my $picture = "$work/class/picture/grade/chebyshev.png";
make_path("$work/class/picture/grade");
symlink "$precious/chebyshev.png", $picture;
$said = graded( 'picture', $PATIENCE );
ok( !-l $picture && png_size( slurp($picture) ) eq '488x90',
    'a picture is never written through a link' );
ok( eval { keep_picture( "$work/class/picture", 'chebyshev.png', 'later' ); 1 },
    'a picture can be kept twice' );
is( slurp($picture), 'later', 'nor lost where another marking made one' );
is( join( ' ', everything_below("$work/class/picture/grade") ),
    'chebyshev.png', 'and nothing else is left there' );
like( $said, qr/$REDUCTION\n +missing: make exercise .* makes it again$/m,
    'a file is missing' );

# Several at once, of any name.
my @names = (
    'it\'s "mine"', "two\nlines\ttab", '-x', '$(touch y)', "\xc3\x84 \xff"
);
my @children;
for my $name (@names) {
    submission( $name, 5, %missing,
        $CHEBYSHEV => slurp( root() . "/step5_chebyshev/shaders/$CHEBYSHEV" ) );
    push @children, start( $name, $PATIENCE );
}
for my $name (@names) {
    waitpid shift @children, 0;
    like( slurp("$work/$name.out"), qr/^right .*^1 of 3 functions right$/ms,
        "a folder named $name" =~ s/[^ -~]/?/gr )
      or diag( slurp("$work/$name.err") );
}
ok( !-e "$work/class/y", 'and nothing is executed' );
symlink 'picture', "$work/class/elsewhere";
my $run = command( grade( $PATIENCE, 5, "$work/class/elsewhere/" ) );
like( $run->{err}, qr/\A.*elsewhere is a link.*\n\z/, 'a link is no folder' );
is( $run->{status}, 2, 'and is refused' );
$run = command( grade( $PATIENCE, 5, "none\e[2J\nright  all" ) );
is( $run->{status}, 2, 'no folder: exit status' );
like( $run->{err}, qr/\Athere is no folder [ -~]+\n\z/, 'in one plain line' );

# Shaders that do not end, ask for too much, or say too much.
# (A sanitizer runs without a limit of memory: nothing large is asked for.)
my ( $depth, $bits ) = $ENV{VSM_SLOW} ? ( 3, 10 ) : ( 15, 28 );
# A driver may end a loop after 2^16 turns: each takes long.
my $turn   = 'p = sin(p + mean); ' x 100;
my $macros = "#define A0 p_max + p_max + p_max + p_max\n" . join '', map {
    my $before = 'A' . ( $_ - 1 );
    "#define A$_ $before + $before + $before + $before\n"
} 1 .. $depth;
submission( 'endless', 5,
    $CHEBYSHEV => body( $CHEBYSHEV, <<"END" ),
    float p = t;
    for (int i = 0; i < 60000; i++) {
        $turn
    }
    return p;
END
    $REDUCTION  => $macros . body( $REDUCTION, "return A$depth;" ),
    $VISIBILITY => body( $VISIBILITY,
        'return ' . '(' x 7000 . '1.0' . ')' x 7000 . ';' )
);
$said = graded( 'endless', $SECONDS );
like( $said, qr/^wrong  .*$CHEBYSHEV\n +It took longer than $SECONDS s: does/m,
    'does not end' );
like( $said, qr/^wrong  .*$REDUCTION\n/m,  'is very long' );
like( $said, qr/^wrong  .*$VISIBILITY\n/m, 'nests deeply' );

submission( 'large', 5,
    $CHEBYSHEV => body( $CHEBYSHEV, <<"END" ),
    float a[1 << $bits];
    for (int i = 0; i < 1000; i++) {
        a[int(t * float((1 << $bits) - 1)) ^ i] = t;
    }
    return a[int(mean * float((1 << $bits) - 1))];
END
    $REDUCTION => qq(#include "/etc/passwd"\n),
    $VISIBILITY => "#line 20001\n"
      . "#error right  all\e[2J\e]0;title\a\r\xe2\x80\xae \xff\n" x 200
);
$said = graded( 'large', $PATIENCE );
like( $said, qr/^wrong  .*$CHEBYSHEV\n +It was stopped by signal \d/m,
    'asks for memory' )
  unless $ENV{VSM_SLOW};
like( $said, qr/^wrong  .*$REDUCTION\n.*not found/m, 'nothing is included' );
like( $said, qr/^wrong  .*$VISIBILITY\n/m, 'errors' );
unlike( $said, qr/^right/m, 'no other line says right' );

# Told to stop, or killed, while a shader runs.
sub shader_runs {    # after the right program
    my @dumps = glob "$work/tmp/*/1/dump";
    return @dumps
      && grep { ( eval { slurp("/proc/$_/comm") } // '' ) =~ /^step5/ } alive();
}

# Whether it comes true in so many seconds.
sub comes_true {
    my ( $most, $true ) = @_;
    my $start = time;
    while ( !$true->() ) {
        return if time > $start + $most;
        sleep 0.05;
    }
    return 1;
}
for my $signal (qw(TERM PIPE USR1 KILL)) {
    my $child = start( 'endless', $PATIENCE );
    comes_true( 60, \&shader_runs );
    kill $signal, $child;
    waitpid $child, 0;
    is( join( ' ', everything_below("$work/tmp") ), '', 'no temporary file' )
      if $signal ne 'KILL';
    ok( comes_true( 3, sub { !alive() } ),
        "no process is left by SIG$signal" );
}

done_testing;
