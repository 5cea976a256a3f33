# A word from outside is data: what DIR, STEP, DEPS, BUILD or any other word
# says is evaluated by no make and no shell, and checked before anything is
# built. All of it in a copy of the tree, whose own path is odd too.
use strict;
use warnings;

use File::Basename qw(dirname);
use File::Path qw(make_path);
use File::Temp qw(tempdir);
use Test::More;
use VSM;

delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};
delete @ENV{qw(STEP DIR DEPS BUILD REPORT)};

my $work = tempdir( CLEANUP => 1 );
my $tree = "$work/it's my copy \$x #1 (b) [c]{d} 100% \"q\" & \\t;*";
mkdir $tree;
chdir root();
command( qw(/bin/cp -r --parents Makefile tests/tests.mk tests/lib),
    'tests/exercise/README.md', ( map { program_name($_) } 1 .. 5 ), $tree );
chdir $tree or die "no copy: $!\n";

# What is evaluated makes this file.
$ENV{MARK} = "$work/evaluated";
my @attacks = (
    '$(shell touch $(MARK))',
    '${shell touch $(MARK)}',
    q{x'; touch "$MARK"; echo '},
    '"; touch "$MARK"; "',
    '$(touch "$MARK")',
    '`touch "$MARK"`',
    '; touch "$MARK" #',
);
my @names = (
    'a b', "it's", 'say "x"', "two\nlines", 'back\\slash', '-C', '--help',
    '%', '#', '*', '~', '$$', '$HOME', 'a=b', ':=c', 'end ', "\xc3\xbc/new",
);

# Nothing is set up or built, and the scripts are one that repeats its words.
spew( 'tests/tests.mk',
    slurp('tests/tests.mk') =~ s/^(exercise|grade|report):[^#]*/$1: /mgr );
spew( 'step1_shadowmap/base/set-up.sh', '' );
for my $script (qw(exercise/exercise exercise/grade report/report)) {
    spew( "tests/$script.pl",
        'print map { "<$_>" } @ARGV, $ENV{REPORT} // ();' );
}

sub make {
    my (@words) = @_;
    unlink $ENV{MARK};
    my $run = command( qw(/usr/bin/env make -s DEPS=no), @words );
    $run->{evaluated} = -e $ENV{MARK};
    return $run;
}

# The words, as the title of a test.
sub title { return "@_" =~ s/\n/\\n/gr }

# --- DIR ---------------------------------------------------------------------

for my $name ( @attacks, @names ) {
    my $what = title("DIR=$name");
    my $run  = make( 'grade', 'STEP=4', "DIR=$name" );
    is( $run->{out}, "<4><$name>", "make grade $what" ) or diag( $run->{err} );
    ok( !$run->{evaluated}, "make grade $what: is not evaluated" );
}
for my $name (@attacks) {
    local $ENV{DIR} = $name;
    my $run = make('exercise');
    is( $run->{out}, "<5><$name>", "make exercise, DIR in the environment" );
    ok( !$run->{evaluated}, 'and is not evaluated' );
}

# What it prints is right for a shell: here make is one that looks for the copy.
for my $name ( @attacks[ 0, 2 ], @names[ 0 .. 5 ], $names[-1] ) {
    my $what = title("DIR=$name");
    my $run  = make( 'standalone', 'STEP=1', "DIR=$name" );
    is( $run->{err}, '', "make standalone $what" );
    ok( !$run->{evaluated}, "$what: is not evaluated" );
    my $program = "./$name/build/step1_shadowmap";
    spew( $program, "#!/bin/sh\necho drawn \$*\n" );
    chmod 0755, $program;
    my $said = command( '/bin/sh', '-c',
        "make() { cat \"\$2/Makefile\"; }\n$run->{out}" );
    is( $said->{out}, <<'END', "$what: is there" ) or diag( $said->{err} );
ROOT := .
include step1_shadowmap/Makefile
drawn --output mine.png
END
}

# A folder that holds anything, or no folder: refused, and left as it is.
make_path( 'full', 'hidden/.git', 'empty' );
spew( 'full/mine.c', 'mine' );
spew( 'file',        'mine' );
spew( "odd/\n",      '' );
symlink 'full',    'to_full';
symlink 'nowhere', 'to_nothing';
my @before = everything_below('.');
for my $name (
    qw(full full/ ./full full/../full hidden odd to_full . .. file to_nothing),
    qw(step4_blur step4_mine step4_blur/new tests tests/images .git/x),
    qw(build out/new),
    "$tree/full"
  )
{
    my $run = make( 'standalone', 'STEP=1', "DIR=$name" );
    is( $run->{status}, 2, "$name is refused" );
    like( $run->{err}, qr/\A\Q$name\E [^\n]*: name [^\n]*\nmake: [^\n]*\n\z/,
        "$name: in a line, besides make's own" );
}
is_deeply( [ everything_below('.') ], \@before, 'and all is as before' );
symlink 'empty', 'to_empty';
my $linked = make(qw(standalone STEP=1 DIR=to_empty));
is( $linked->{status}, 0, 'a link to an empty folder' );
ok( -f 'empty/Makefile', 'is that folder' );

# --- words that are checked before anything is done ------------------------

my @steps  = ( '', qw(6 0 abc 03 -1 % 1.0), '1 2', '3 ', "3\n", @attacks );
my @deps   = ( '', qw(maybe YES),           'no yes', 'no ', @attacks );
my @builds = ( '', 'x y', "x'y", 'x ', 'x:y', @attacks );
my @refused = (
    ( map { [ $_, 'STEP=6' ] }
          qw(standalone lesson exercise grade shader window diff all) ),
    [ 'diff', 'STEP=1' ],
    ( map { [ 'test', "STEP=$_" ] } @steps ),
    ( map { [ 'test', "DEPS=$_" ] } @deps ),
    ( map { [ 'test', "BUILD=$_" ] } @builds ),
    ( map { [ $_, 'DIR=' ] } qw(standalone lesson exercise grade) ),
    ( map { [$_] } qw(standalone lesson exercise grade) ),
);
for my $words (@refused) {
    my ( $goal, $word ) = @$words;
    my $run = make( "@$words" =~ /DIR|^\w+$/ ? () : 'DIR=new', @$words );
    my $what = title( 'make', @$words );
    my $told = "@$words" =~ /(STEP|DEPS|BUILD)=/ ? "$1 (?:is|names)" : 'where';
    is( $run->{status}, 2, "$what is refused" );
    like( $run->{err}, qr/\A[^\n]* $told[^\n]*\n\z/, "$what: in one line" );
    is( $run->{out}, '', "$what: before anything is done" );
    ok( !$run->{evaluated}, "$what: is not evaluated" );
}
for my $name (qw(STEP DEPS)) {
    local $ENV{$name} = $attacks[0];
    my $run = command(qw(/usr/bin/env make -s test));
    like( $run->{err}, qr/ $name is [^\n]*\n\z/, "$name in the environment" );
    ok( !-e $ENV{MARK}, "$name in the environment is not evaluated" );
}
for my $name (qw(BUILD DEPS)) {
    my $alone = make( qw(-C step1_shadowmap), "$name=$attacks[0]" );
    is( $alone->{status}, 2, "one step alone: $name is refused" );
    ok( !$alone->{evaluated}, "one step alone: $name is not evaluated" );
}

for my $word (@attacks) {
    my $run = make( 'report', "REPORT=$word" );
    is( $run->{out}, "<$word>", "make report REPORT=$word" );
    ok( !$run->{evaluated}, "REPORT=$word is not evaluated" );
}

# The Makefiles' own names, and those of a single folder.
for my $word ( map { ( "before=$_", "base=$_", "OTHER=$_" ) } @attacks ) {
    my $run = make( 'diff', 'STEP=2', $word );
    is( $run->{status}, 2, title( $word, 'is refused' ) );
    ok( !$run->{evaluated}, title( $word, 'is not evaluated' ) );
}
for my $name (qw(ROOT PROGRAMS)) {
    local $ENV{$name} = $attacks[0];
    my $run = make(qw(-C step1_shadowmap set-up));
    is( $run->{status}, 0, "one step alone: $name in the environment" )
      or diag( $run->{err} );
    ok( !$run->{evaluated}, "$name in the environment is not evaluated" );
}

# --- a class -----------------------------------------------------------------

# The guide's loop over folders that students have named.
my ($loop) = slurp('tests/exercise/README.md') =~ /^ {4}(for d in .*)$/m;
SKIP: {
    skip 'the guide has no loop', 1 if !defined $loop;
    make_path("class/$_") for grep { !m{/} } @attacks, @names;
    my $run = command( '/bin/sh', '-c', $loop );
    is( $run->{err}, '', 'a class: nothing is complained of' );
    my @marks = map { slurp("$_.txt") } grep { -d } glob 'class/*';
    is_deeply(
        \@marks,
        [ map { "<5><$_/>" } grep { -d } glob 'class/*' ],
        'a class: each folder by its name'
    );
    ok( !-e $ENV{MARK}, 'a class: nothing is evaluated' );
}

# --- the tree's own path -----------------------------------------------------

symlink dirname( program(1) ), 'build';
my $said;
{
    delete local $ENV{VSM_BUILD};
    $said = command( $^X, '-Itests/lib', '-MVSM', '-e', <<'END');
print map { program_name($_), "\n" } 1 .. 5;
my $picture = root() . '/p.exr';
run_warm( 1, qw(--size 16x9 --output), $picture );
print ask_oracle( 'compare', $picture, $picture, 'max=0' )->{status}, "\n";
END
}
is( $said->{out}, join( "\n", ( map { program_name($_) } 1 .. 5 ), 0, '' ),
    'the tests find the steps, draw and compare' )
  or diag( $said->{err} );

my $odd = "$work/a\tb\nc";
mkdir $odd;
command( program(1), qw(--size 16x9 --output), "$odd/p.exr" );
oracle( 'compare', "$odd/p.exr", "$odd/p.exr", 'max=0' );

# --- make help ---------------------------------------------------------------

# Every goal for people is in one of four groups.
my $help = make( '-C', root(), 'help' )->{out};
is( join( ' ', $help =~ /^to (\w+):$/mg ),
    'read measure teach maintain', 'make help has four groups' );
my ($goals) = slurp( root() . '/Makefile' ) =~ /^\.PHONY: ((?:.*\\\n)*.*)/m;
for ( grep { !/^(?:programs|set-up-tests|warm|\\)$/ } split ' ', $goals ) {
    my @told = $help =~ /^  \Q$_\E +\S/mg;
    is( @told, 1, "make help tells what $_ is" );
}

# --- what the guides make ----------------------------------------------------

# Where the READMEs' own commands write, git does not look.
my %ignored =
  map { $_ => 1 } slurp( root() . '/.gitignore' ) =~ m{^/(.*?)/?$}mg;
chdir root();
for my $guide ( 'README.md', glob('*/README.md'), glob('tests/*/README.md') ) {
    for ( slurp($guide) =~ /^(?: {4}|\| `)(.*)/mg ) {
        my @paths = /(?:DIR=|--output |--dump |mkdir -p |for d in )([\w.]+)/g;
        ok( $ignored{$_}, "$guide: git ignores $_" ) for @paths;
    }
}

done_testing;
