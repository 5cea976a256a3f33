# The committed pictures are what the programs draw.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Test::More;
use VSM;

my $folder = tempdir( CLEANUP => 1 );

# llvmpipe gives the same bits on every run; another processor may round one
# value in a thousand differently.
my @tolerance = map { ( "-$_", 0.004, "-${_}percent", 0.1 ) } qw(warn fail);

for my $step ( 1 .. 5 ) {
    my $name   = program_name($step);
    my $figure = root() . "/$name/figure.png";
    my $now    = "$folder/$name.png";
    my $run    = run( $step, qw(--size 640x360 --output), $now );
    is( $run->{status} . $run->{err}, '0', "step $step draws its figure" )
      or next;
    is( png_size( slurp($figure) ), '640x360', "$name/figure.png is 640x360" );
    my $compared =
      command( '/usr/bin/env', 'idiff', @tolerance, $figure, $now );
    is( $compared->{status}, 0,
        "$name/figure.png: within 1/255 on 99.9 % of the pixels" )
      or diag( $compared->{out}, $compared->{err},
        'after a change that is wanted: make figures' );
}

done_testing;
