# The table that `make` and `make table` print.
use strict;
use warnings;

use File::Basename qw(dirname);
use File::Temp qw(tempdir);
use Test::More;
use VSM;

my $build = dirname( program(1) );
my $work  = tempdir( CLEANUP => 1 );
chdir $work or die "cannot work in $work: $!\n";

sub rows {
    my ($folder) = @_;
    my $run = command( '/bin/sh', root() . '/tests/report/table.sh',
        $folder, '160x90' );
    is( $run->{status}, 0, 'a table' ) or diag( $run->{err} );
    my @rows = $run->{out} =~ /^(step\d_.*)/mg;
    is( scalar @rows, 5, 'of five steps' );
    return ( $run->{out}, map { [ split ' ' ] } @rows );
}

my ( $out, @rows ) = rows($build);
unlike( $out, qr/make table/, 'nothing is missing' );
for my $step ( 1 .. 5 ) {
    my ( $name, $map, $shading, $frame, @wrong ) = @{ $rows[ $step - 1 ] };
    is( $name, program_name($step), $name );
    cmp_ok( $_, '>', 0, "$name: $_ ms" ) for $map, $shading, $frame;
    my %rmse = map { ( split /,/ )[ 0, 4 ] } split /\n/,
      slurp("out/table/$name/errors.csv");
    my @said = map { sprintf '%.3f', $rmse{$_} } qw(footprint hard);
    is( "@wrong", "@said", "$name: as wrong as the oracle says" );
}

# Without an oracle it says what it can.
symlink "$build/" . program_name($_), "$work/" . program_name($_) for 1 .. 5;
( $out, @rows ) = rows($work);
like( $out, qr/make table: how wrong/, 'and how to get the rest' );
$out =~ s/make table.*//;
unlike( $out, qr/wrong/i, 'without a word of the rest' );
is( scalar @$_, 4, "$_->[0]: nothing is made up" ) for @rows;

chdir '/';
done_testing;
