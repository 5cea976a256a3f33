# What the tests share: running the programs, the oracle and other commands,
# and turning what happened into TAP. Core modules only.
#
# VSM_SHADERS=DIR  every program looks for its shaders there first; how
#                  `make mutants` plants its mistakes
# VSM_BUILD=DIR    where the programs are, if not in build/
# VSM_PATIENCE=N   seconds that a window may take to react, in place of 300
# VSM_STEP=N       only what is of step N (make test STEP=N)
# VSM_SLOW=1       ten times the time limit, for builds with a sanitizer
package VSM;

use strict;
use warnings;

use Cwd qw(abs_path getcwd);
use Exporter qw(import);
use File::Basename qw(basename dirname);
use File::Find qw(find);
use File::Glob qw(bsd_glob);
use File::Path qw(make_path remove_tree);
use File::Spec;
use File::Temp qw(tempdir);
use IPC::Open2 qw(open2);
use POSIX ();
use Test::More;
use Failing qw(is_about made);

our @EXPORT = qw(root program_name program command run run_warm dump_run
  oracle ask_oracle oracle_errors slurp spew everything_below matching png_size
  stops of_steps is_chosen);

# Made absolute at once: a test may change its working directory.
my $ROOT    = abs_path( dirname(__FILE__) . '/../..' );
my $SHADERS = $ENV{VSM_SHADERS} && File::Spec->rel2abs( $ENV{VSM_SHADERS} );
my $BUILD   = File::Spec->rel2abs( $ENV{VSM_BUILD} // 'build', $ROOT );
my $START   = getcwd();    # nobody's own

# A command may take. What has to come to an end in a test does so at last on a
# machine that does ten other things.
our $SECONDS =
  ( $0 =~ /\.t\z/ ? 300 : 60 ) * ( $ENV{VSM_SLOW} ? 10 : 1 );
our $running;    # process that command() waits for

my %dumps;    # folder by step and arguments

sub root { return $ROOT }

# "step3_moments" for 3.
sub program_name {
    my ($step) = @_;
    my ($folder) = matching( $ROOT, "step${step}_*" )
      or die "there is no step $step\n";
    return basename($folder);
}

sub program { return "$BUILD/" . program_name(@_) }

# Runs a command without a shell, with nothing to read and a time limit.
# Returns {status, signal, out, err}; running out of time is signal 14.
sub command {
    my @words = @_;
    is_about(@words) if $words[0] =~ m{/};    # not where a test looks on
    my $out   = File::Temp->new;
    my $err   = File::Temp->new;
    my $child = fork // die "cannot fork: $!\n";
    if ( $child == 0 ) {
        open STDIN,  '<',  '/dev/null';
        open STDOUT, '>&', $out;
        open STDERR, '>&', $err;
        alarm $SECONDS;    # goes on across exec
        no warnings 'exec';    # the line below says it
        exec { $words[0] } @words;
        print STDERR "cannot run $words[0]: $!\n";
        POSIX::_exit(127);    # not exit: the END blocks are the parent's
    }
    # A signal's handler breaks off the wait.
    local $running = $child;
    1 while waitpid( $child, 0 ) < 0 && $!{EINTR};
    return {
        status => $? >> 8,
        signal => $? & 127,
        out    => slurp( $out->filename ),
        err    => slurp( $err->filename ),
    };
}

# Runs a step's program. A --shaders among the arguments comes later and wins.
sub run {
    return command( words_of(@_) );
}

sub words_of {
    my ( $step, @arguments ) = @_;
    my @shaders = $SHADERS ? ( '--shaders', $SHADERS ) : ();
    return ( program($step), @shaders, @arguments );
}

# The same by a program that stays (tests/warm.c) and has loaded already what
# takes longest. For tests of pictures: what the command line does, run() shows.
# Without such a program, or in another environment, it is run().
my %warm;    # by step: the pipes, and the environment at the start

sub run_warm {
    my ( $step, @arguments ) = @_;
    my $warm = $warm{$step} //= start_warm($step);
    my ( undef, @words ) = my @all = words_of( $step, @arguments );
    return run( $step, @arguments )
      if !$warm->{to} || $warm->{environment} ne environment()
      || grep { /[\t\n]/ } abs_path('.'), @words;
    is_about(@all);
    my ( $out, $err ) = ( File::Temp->new, File::Temp->new );
    local $SIG{PIPE} = 'IGNORE';
    print { $warm->{to} } join( "\t",
        abs_path('.'), $out->filename, $err->filename, $SECONDS, @words ),
      "\n";
    $warm->{to}->flush;
    my ( $status, $signal ) = split ' ', readline( $warm->{from} ) // '126 0';
    return {
        status => $status,
        signal => $signal,
        out    => slurp( $out->filename ),
        err    => slurp( $err->filename ),
    };
}

# Not what an earlier build left; and what looks for leaks has to see the end
# of a program, which these skip.
sub start_warm {
    my ($step) = @_;
    my $program = "$BUILD/warm/" . program_name($step);
    return {}
      if $ENV{VSM_SLOW} || !-e $program || -M $program > -M program($step);
    my $child = open2( my $from, my $to, $program, 'serve' );
    return {
        child       => $child,
        from        => $from,
        to          => $to,
        environment => environment()
    };
}

sub environment {
    return join "\0", map { "$_=$ENV{$_}" } sort keys %ENV;
}

END {
    local $?;
    for my $warm ( grep { $_->{to} } values %warm ) {
        close $warm->{to};
        waitpid $warm->{child}, 0;
    }
}

# The folder with the --dump of a run, its picture as picture.exr among it.
# The same run is made once for a process; its folder is this process's own
# and goes with it.
sub dump_run {
    my ( $step, @arguments ) = @_;
    my $key = join "\0", $SHADERS // '', $step, @arguments;
    my $folder = $dumps{$key} // tempdir( CLEANUP => 1 );
    my @words =
      ( @arguments, '--dump', $folder, '--output', "$folder/picture.exr" );
    made( $folder, words_of( $step, @words ) );
    return $folder if $dumps{$key};
    my $run = run_warm( $step, @words );
    die "$run->{err}step $step @arguments: exit status $run->{status}, "
      . "signal $run->{signal}\n"
      if $run->{status} || $run->{signal};
    return $dumps{$key} = $folder;
}

# What the oracle says to these words: {status, signal, out}. One oracle for
# a test file answers them all, for it takes longer to load than to answer.
my ( $ask, $told, $oracle );

sub ask_oracle {
    my @words = @_;
    is_about( "$BUILD/oracle", @words );
    if ( grep { /[\t\n]/ } @words ) {
        my $run = command( "$BUILD/oracle", @words );
        return { %$run, out => $run->{out} . $run->{err} };
    }
    local $SIG{PIPE} = 'IGNORE';
    $oracle //= open2( $told, $ask, "$BUILD/oracle", 'serve', $SECONDS );
    print $ask join( "\t", @words ), "\n";
    $ask->flush;
    my $out = '';
    while ( defined( my $line = <$told> ) ) {
        return { status => $1, signal => $2, out => $out }
          if $line =~ /^END (\d+) (\d+)$/;
        $out .= $line;
    }
    undef $oracle;
    return { status => 2, signal => 0, out => "${out}it has stopped\n" };
}

# What the oracle's `errors` says of a dump: {truth}{column}.
sub oracle_errors {
    my ( $dump, @words ) = @_;
    my $answer = ask_oracle( 'errors', $dump, @words );
    $answer->{status} == 0 or fail("errors: status $answer->{status}");
    my ( $head, @lines ) = split /\n/, $answer->{out};
    my %errors;
    for (@lines) {
        my %row;
        @row{ split /,/, $head } = split /,/;
        $errors{ $row{truth} } = \%row;
    }
    return %errors;
}

END {
    if ($oracle) {
        local $?;
        close $ask;
        waitpid $oracle, 0;
    }
}

# Asks the oracle about a dump: one test for each line of its answer. Returns
# whether all passed.
sub oracle {
    my ( $check, $folder, @arguments ) = @_;
    my $run = ask_oracle( $check, $folder, @arguments );
    my ( $lines, $passed ) = ( 0, 1 );
    for ( split /\n/, $run->{out} ) {
        my ( $verdict, $text ) = /^(PASS|FAIL) (.*)/ or next;
        $lines++;
        $passed &= ok( $verdict eq 'PASS', "$check: $text" );
    }
    return $passed if $lines && $run->{status} < 2 && !$run->{signal};
    fail("$check: the oracle answers");
    diag( "@arguments: exit status $run->{status}, signal $run->{signal}, "
          . "$lines lines\n$run->{out}" );
    return 0;
}

sub slurp {
    my ($path) = @_;
    open my $file, '<:raw', $path or die "cannot read $path: $!\n";
    local $/;
    return <$file> // '';
}

# Writes a file, and the folders above it.
sub spew {
    my ( $path, $text ) = @_;
    make_path( dirname($path) );
    open my $file, '>:raw', $path or die "cannot write $path: $!\n";
    print $file $text;
    close $file or die "cannot write $path: $!\n";
    return;
}

# Every file and folder below a folder, sorted, as paths from there.
sub everything_below {
    my ($folder) = @_;
    my @paths;
    my $note = sub {
        push @paths, File::Spec->abs2rel( $_, $folder ) if $_ ne $folder;
    };
    find( { wanted => $note, no_chdir => 1 }, $folder );
    return sort @paths;
}

# The paths below a folder that match a pattern. The folder's own name is none,
# whatever characters are in it.
sub matching {
    my ( $folder, $pattern ) = @_;
    return bsd_glob( $folder =~ s/([][{}*?~\\])/\\$1/gr . "/$pattern" );
}

# "160x90", or "" for what is no PNG. Width and height follow the signature
# and the name of the first chunk.
sub png_size {
    my ($bytes) = @_;
    my ( $start, $wide, $high ) = unpack 'a16 N N', $bytes;
    return defined $high && $start =~ /^\x89PNG\r\n.*IHDR$/s
      ? "${wide}x$high"
      : '';
}

sub go_to {
    my ($folder) = @_;
    chdir $folder or die "cannot work in $folder: $!\n";
    return;
}

# One test: the code runs something that has to stop with this exit status,
# with exactly one line on stderr which matches every pattern, and without
# leaving anything new in the working directory. A test that has not gone to a
# folder of its own is taken to an empty one for this: what appears where it
# was started may be anybody's.
#     stops { run( 1, '--size', 0 ) } 2, [qr/--size/], 'no empty picture';
sub stops(&$$$) {
    my ( $code, $status, $patterns, $name ) = @_;
    my $here  = getcwd();
    my $empty = File::Temp->newdir;
    go_to($empty) if $here eq $START;
    my %before = map { $_ => 1 } everything_below('.');
    my $run    = $code->();
    my @new    = grep { !$before{$_} } everything_below('.');

    my @wrong;
    push @wrong, "killed by signal $run->{signal}" if $run->{signal};
    push @wrong, "exit status $run->{status}, not $status"
      if $run->{status} != $status;
    push @wrong, 'not one line on stderr' if $run->{err} !~ /\A[^\n]+\n\z/;
    push @wrong, map { "does not match $_" }
      grep { $run->{err} !~ $_ } @$patterns;
    push @wrong, "left behind: @new" if @new;

    remove_tree(@new) if @new;    # the next test starts afresh
    go_to($here);
    ok( !@wrong, $name ) and return 1;
    diag( join "\n", @wrong, "stderr: $run->{err}" );
    return 0;
}

# Whether a step is to be tested.
sub is_chosen {
    my ($step) = @_;
    return !$ENV{VSM_STEP} || $ENV{VSM_STEP} == $step;
}

# A test file of several steps: skipped if it has nothing of the chosen one.
sub of_steps {
    plan( skip_all => 'nothing of this step' ) if !grep { is_chosen($_) } @_;
    return;
}

1;
