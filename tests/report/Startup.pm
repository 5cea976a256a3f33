# From the start of a program to its picture on disk, and where the time goes:
# told apart by runs that stop earlier.
package Startup;

use strict;
use warnings;

use Exporter    qw(import);
use File::Temp  qw(tempdir);
use List::Util  qw(max);
use POSIX       ();
use Time::HiRes qw(clock time);
use VSM;
use Measure qw(processors quantile);

our @EXPORT_OK = qw(starts_within startup waits);

sub seconds_of {
    my @words = @_;
    my $begun = time;
    command(@words);
    return time - $begun;
}

# How many times as long as it computes something takes that computes on every
# processor at once: 1 where nothing else wants them.
sub waits {
    my @children = map {
        my $child = open my $from, '-|';
        defined $child or die "cannot fork: $!\n";
        if ( !$child ) {
            my ( $begun, $computed ) = ( time, clock );
            1 until clock() - $computed > 0.05;
            syswrite STDOUT, ( time - $begun ) / ( clock() - $computed );
            POSIX::_exit(0);
        }
        $from;
    } processors();
    return max( map { scalar readline $_ } @children );
}

# Whether a start takes so many seconds at most: 1, 0, or undef where it waited
# for others.
sub starts_within {
    my ( $most, $whole, $waits ) = @_;
    return 1 if $whole <= $most;
    return   if $waits > 1.2;
    return 0;
}

# Of the default picture of step 5: the median seconds of so many rounds, the
# median of `waits` meanwhile, and [what, seconds] of its parts.
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
    my ( %samples, @waits );
    for ( 1 .. $rounds ) {
        push @waits, waits();
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
    return ( $at{whole}, quantile( 0.5, @waits ), @parts );
}

1;
