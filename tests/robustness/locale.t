# Where a locale writes numbers with commas: what is printed and read has
# points all the same.
use strict;
use warnings;

use File::Temp qw(tempdir);
use POSIX      qw(localeconv setlocale LC_NUMERIC);
use Test::More;
use VSM;

my $work = tempdir( CLEANUP => 1 );
chdir $work or die "cannot work in a temporary folder\n";

# Such a locale is made here: few systems have one.
my $made = command( qw(/usr/bin/env localedef -i de_DE -f UTF-8),
    "$work/de_DE.UTF-8" );
plan skip_all => 'there is no localedef' if $made->{status} == 127;
is( $made->{status}, 0, 'a German locale' ) or diag( $made->{err} );
$ENV{LOCPATH} = $work;
setlocale( LC_NUMERIC, 'de_DE.UTF-8' );
is( localeconv()->{decimal_point}, ',', 'that has commas' );
setlocale( LC_NUMERIC, 'C' );

# What a command prints there, and in the locale that C starts with.
sub both {
    my @words = @_;
    return map {
        local $ENV{LC_ALL} = $_;
        my $run = command(@words);
        is( $run->{status} . $run->{err}, '0', "@words" );
        $run->{out};
    } qw(de_DE.UTF-8 C);
}

# The programs and the oracle.
mkdir 'dump';
my @facts;
both( program(5), qw(--size 160x90 --dump dump --output dump/picture.png
    --slope-term --bleed-reduction 0.25) );
my $run = slurp('dump/run.json');
like( $run, qr/"bleed-reduction": 0\.25,/, 'run.json: an option' );
like( $run, qr/"ms": \d+\.\d+\}/,          'run.json: a time' );
my ( $comma, $point ) = both( program(5), '--list-scenes' );
is( $comma, $point, 'scenes' );
( $comma, $point ) =
  both( program(5), '--plan', qw(--size 160x90) );
is( $comma, $point, 'a plan' );
($comma) = both( program(5), qw(--size 160x90 --bench 1 --redraw) );
like( $comma, qr/^total(?:,\d+\.\d+){3},1,/m, 'times' );
my $oracle = program(1) =~ s{[^/]*$}{oracle}r;
( $comma, $point ) = both( $oracle, 'errors', 'dump' );
is( $comma, $point, 'errors' );

# A plot's numbers.
spew( 'fuzz.csv', "format,taps,condition,error_bits,bound_bits\n"
      . join '', map { "fp32-raw,3,$_.5,$_.25,8.5\n" } 2 .. 20 );
both( qw(/usr/bin/env gnuplot -e), "kind='svg'; input='fuzz.csv'; "
      . 'output=system("echo $LC_ALL").".svg"',
    root() . '/tests/stability/fuzz.gp' );
is( slurp('de_DE.UTF-8.svg'), slurp('C.svg'), 'a plot' );

# The scripts, of programs that say these numbers.
sub script {
    my ( $name, $text ) = @_;
    spew( $name, "#!/bin/sh\n$text" );
    chmod 0755, $name;
    return;
}
script( "build/step${_}_x", 'printf "pass,median_ms\nshading,1.25\n'
      . 'total,12.5\n"' )
  for 1 .. 5;
script( 'build/oracle', 'printf "truth,a,b,c,rmse\nfootprint,1,2,3,0.0625\n'
      . 'hard,1,2,3,0.1875\n"' );
($comma) = both( '/bin/sh', root() . '/tests/report/table.sh', 'build' );
my @rows = $comma =~ /^step\d_x +(.*)/mg;
is( scalar @rows, 5, 'table.sh' );
like( $_, qr/^11\.2 +1\.2 +12\.5 +0\.06[23] +0\.18[78]$/, 'table.sh: a row' )
  for @rows;

script( 'bin/gnuplot', 'printf "%s " "$@"' );
script( 'bin/perl',    'printf "scene,technique,width,total_ms,total_q1,'
      . 'total_q3,footprint_rmse,label,map_ms,blur_ms,shading_ms,light_rmse\n'
      . 'teapot,PCF,7,10.5,10.25,10.75,0.0625,PCF 7,1.25,0,9.5,0.125\n"'
      . '>"$REPORT_OUT/results.csv"' );
mkdir 'stepx';
local $ENV{PATH} = "$work/bin:$ENV{PATH}";
($comma) =
  both( '/bin/sh', root() . '/tests/report/figures.sh', 'build', 'step1_x' );
like( $comma, qr/truth, RMSE 0\.0625'/, 'figures.sh' );
($comma) = both( '/bin/sh', root() . '/tests/report/headline.sh', 'build' );
like( $comma, qr/^PCF 7 +1\.[23] +9\.5 +0\.06[23] +0\.125$/m, 'headline.sh' );
is( slurp('out/figures/report/PCF.dat'),
    "7 10.5 10.25 10.75 0.0625\n", 'headline.sh: points of the plot' );

# And whatever the next script prints.
for my $name ( grep { /\.sh$/ } everything_below( root() ) ) {
    next if $name =~ m{^(?:build|out)/};
    like( slurp( root() . "/$name" ), qr/^export LC_ALL=C\b/m, $name );
}

chdir '/';
done_testing;
