# `make report`: the same numbers again, and what it does when it is broken
# off, when a program crashes, and when there is no place to write.
use strict;
use warnings;

use Cwd        qw(abs_path);
use File::Temp qw(tempdir);
use JSON::PP   qw(decode_json);
use Test::More;
use VSM;

my $folder = tempdir( CLEANUP => 1 );
my $build  = program(1) =~ s{/[^/]+$}{}r;

# A sweep of five points; @words go before the command.
sub report {
    my ( $out, $programs, @words ) = @_;
    local $ENV{REPORT}     = 'tiny';
    local $ENV{REPORT_OUT} = "$folder/$out";
    local $ENV{VSM_BUILD}  = $programs;
    local $VSM::SECONDS    = 600;           # a dozen commands, of a minute each
    return command( @words, $^X, root() . '/tests/report/report.pl' );
}

# The programs, of which some steps are a shell script in place of the real one.
sub with_fake {
    my ( $name, $script, @steps ) = @_;
    my $programs = "$folder/$name";
    mkdir $programs;
    symlink "$build/oracle", "$programs/oracle";
    for my $step ( 1 .. 5 ) {
        my $path = "$programs/" . program_name($step);
        if ( grep { $_ == $step } @steps ) {
            spew( $path, "#!/bin/sh\nreal=" . quotemeta( program($step) ) . "\n$script" );
            chmod 0755, $path;
        }
        else { symlink program($step), $path }
    }
    return $programs;
}

# results.csv as {label}{column}
sub rows_of {
    my ($out) = @_;
    my ( $head, @lines ) = split /\n/, slurp("$folder/$out/results.csv");
    my %rows;
    for (@lines) {
        my %row;
        @row{ split /,/, $head } = map { $_ // '' } split /,/, $_, -1;
        $rows{ $row{label} } = \%row;
    }
    return %rows;
}

sub files_of {
    my ($out) = @_;
    return join ' ',
      grep { -f "$folder/$out/$_" && !/^kept/ }
      everything_below("$folder/$out");
}

# --- all goes well -----------------------------------------------------------

# A name with a space, and a file that has its first word for a name.
spew( "$folder/the", 'mine' );
my $first = report( 'the first', $build );
is( $first->{status}, 0, 'five points are measured' )
  or diag( $first->{out}, $first->{err} );
ok( -e "$folder/the", 'nothing else is removed' );
is(
    files_of('the first'),
    'index.html results.csv results.json',
    'a page, a table, and what it was measured on'
);
like( $first->{err}, qr/\d of \d+, \d:\d\d left/, 'progress, and time left' );
my %first = rows_of('the first');
my @names = ( 'PCF 3', 'PCF 7', 'VSM 3', 'VSM 7', 'hard' );
is( join( ', ', sort keys %first ), join( ', ', @names ), 'the points' );

my $about   = decode_json( slurp("$folder/the first/results.json") );
my @columns = map { $_->{name} } @{ $about->{columns} };
is(
    join( ',', @columns ),
    ( split /\n/, slurp("$folder/the first/results.csv") )[0],
    'each column is documented'
);
ok(
    !(
        grep { ( $about->{environment}{$_} // '' ) eq '' }
        qw(cpu cores commit gl_renderer gl_version clock date)
    ),
    'the environment is known'
);
ok( ( grep { $_->{reason} =~ /REPORT=tiny is for/ } @{ $about->{left_out} } ),
    'it says that this is not all' );

# The links of a point's error add up: their means to the mean of all. Seven
# numbers of six digits each.
for my $name (@names) {
    my $sum = 0;
    $sum += $first{$name}{$_} || 0 for grep { /^chain_.*_mean$/ } @columns;
    ok( abs( $sum - $first{$name}{light_mean} ) < 1e-6,
        "$name: the chain's means add up" );
}

my $again = report( 'the first', $build );
is( $again->{status}, 0, 'once more' );
like(
    $again->{out},
    qr/5 of them from an earlier run/,
    'nothing is measured twice'
);
is_deeply( { rows_of('the first') }, \%first, 'the same results, and front' );

# --- a program crashes -------------------------------------------------------

# It is asked about two widths; one of them ends in a signal.
my $crashing = with_fake( 'crashing', <<'END', 2 );
case "$*" in *'--kernel 7'*) kill -SEGV $$ ;; esac
exec "$real" "$@"
END
my $crashed = report( 'the first', $crashing );
is( $crashed->{status}, 3, 'a crash: the exit status tells' );
like(
    $crashed->{out},
    qr/^MISSING edge PCF 7: killed by signal 11/m,
    'a crash: the terminal names the point'
);
my $page = slurp("$folder/the first/index.html");
like( $page, qr/edge PCF 7: killed by signal 11/, 'a crash: so does the page' );
my %crashed = rows_of('the first');
is( $crashed{'PCF 7'}{footprint_rmse}, '', 'a crash: no number is made up' );
is(
    $crashed{'PCF 3'}{footprint_rmse},
    $first{'PCF 3'}{footprint_rmse},
    'a crash: the other points are there'
);
unlike( $crashed->{out}, qr/^FAILS/m, 'a crash: no claim about what is not' );
my $repaired = report( 'the first', $build );
is( $repaired->{status}, 0, 'repaired: complete again' );

# --- a claim does not hold ---------------------------------------------------

# A minimum variance that lets light through where there is none.
my $leaking = with_fake( 'leaking', <<'END', 5 );
exec "$real" "$@" --min-variance 0.01
END
my $leaked = report( 'the first', $leaking );
is( $leaked->{status}, 1, 'a claim fails: the exit status tells' );
like(
    $leaked->{out},
    qr/^FAILS edge: VSM 7 against same-weights PCF: RMSE 0\.\d/m,
    'a claim fails: the terminal names it'
);
like(
    slurp("$folder/the first/index.html"),
    qr/FAILS: edge: VSM 7/,
    'a claim fails: so does the page'
);

# --- broken off --------------------------------------------------------------

# Ctrl-C while step 5 draws: its answer comes too late.
my $breaking = with_fake( 'breaking', <<'END', 5 );
case "$*" in *--dump*) kill -INT $PPID ;; esac
exec "$real" "$@"
END
my $broken = report( 'broken', $breaking );
is( $broken->{status}, 3, 'broken off: the exit status tells' );
like(
    $broken->{out},
    qr/MISSING edge VSM 3, edge VSM 7: not measured: it was broken off/,
    'broken off: it says what is missing'
);
is(
    files_of('broken'),
    'index.html results.csv results.json',
    'broken off: the page is made'
);
my %broken = rows_of('broken');
is(
    $broken{'PCF 7'}{footprint_rmse},
    $first{'PCF 7'}{footprint_rmse},
    'broken off: what there was is on it'
);
my $resumed = report( 'broken', $build );
is( $resumed->{status}, 0, 'resumed: complete' );
like( $resumed->{err}, qr/ of 7,/, 'resumed: only what was missing' );

# All of it was measured afresh, by the same programs.
my %fresh = rows_of('broken');
for my $name (@names) {
    is(
        join( ' ',
            map  { $fresh{$name}{$_} }
            grep { !/_(?:ms|q1|q3)$|front/ } @columns ),
        join( ' ',
            map    { $first{$name}{$_} }
              grep { !/_(?:ms|q1|q3)$|front/ } @columns ),
        "$name: measured afresh, the same errors to the last digit"
    );
}

# --- no place to write -------------------------------------------------------

# As in bad_input.t: a limit on the size of a file breaks off a write as a
# full disk does. Blocks of 512 bytes: enough for a page, not for a dump. One
# step that draws is enough.
my $one     = with_fake( 'one', "exit 1\n", 2 .. 5 );
my @limited = ( '/bin/sh', '-c', 'trap "" XFSZ; ulimit -f $0; exec "$@"' );
my $full    = report( 'full', $one, @limited, 120 );
is( $full->{status}, 3, 'a full disk: the exit status tells' );
like(
    $full->{out},
    qr/^MISSING edge hard: .*cannot write/m,
    'a full disk: it says what is missing, and why'
);
is(
    files_of('full'),
    'index.html results.csv results.json',
    'a full disk: the page is made where it has room'
);
my $none = report( 'none', $build, @limited, 1 );
is( $none->{status}, 2, 'no room at all: the exit status tells' );
like(
    $none->{err},
    qr/^report: cannot write [^\n]*results\.csv[^\n]*\n\z/m,
    'no room at all: one line'
);
is( files_of('none'), '', 'no room at all: no part of a file is left' );

# --- bad usage ---------------------------------------------------------------

{
    local $ENV{REPORT} = 'everything';
    my $run = command( $^X, root() . '/tests/report/report.pl' );
    is(
        "$run->{status} $run->{err}",
        "2 report: REPORT=everything: one of full, headline, quick, "
          . "tiny is needed\n",
        'an unknown mode is refused'
    );
}

done_testing;
