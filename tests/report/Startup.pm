# From the start of a program to its picture on disk, and where the time goes:
# told apart by runs that stop earlier.
package Startup;

use strict;
use warnings;

use Exporter    qw(import);
use File::Temp  qw(tempdir);
use List::Util  qw(sum0);
use Time::HiRes qw(time);
use VSM;
use Measure qw(quantile);

our @EXPORT_OK = qw(startup);

sub seconds_of {
    my @words = @_;
    my $begun = time;
    command(@words);
    return time - $begun;
}

# Of the default picture of step 5: the median seconds of so many rounds, and
# [what, seconds] of its parts.
sub startup {
    my ($rounds) = @_;
    my $folder   = tempdir( CLEANUP => 1 );
    my $program  = program(5);
    my @picture  = ( '--output', "$folder/a.png" );

    # The last program to be compiled.
    spew( "$folder/step1_shadowmap/shaders/scene.frag", "no such shader\n" );
    my %stop = (
        help   => [ $program, '--help' ],
        broken => [ $program, @picture, '--shaders', $folder ],
        small  => [ $program, @picture, '--size',    '16x9' ],
        whole  => [ $program, @picture ],
    );
    my %samples;
    for ( 1 .. $rounds ) {
        push @{ $samples{$_} }, seconds_of( @{ $stop{$_} } )
          for sort keys %stop;
    }
    my %at    = map { $_ => quantile( 0.5, @{ $samples{$_} } ) } keys %samples;
    my @parts = (
        [ 'the program and OSMesa loaded', $at{help} ],
        [ 'context, scene, shaders',       $at{broken} - $at{help} ],
        [
            'machine code of the shaders, the map',
            $at{small} - $at{broken}
        ],
        [ 'the pixels drawn, encoded, written', $at{whole} - $at{small} ],
    );
    return ( $at{whole}, @parts );
}

1;
