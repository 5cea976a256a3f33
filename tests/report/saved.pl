#!/usr/bin/perl
# What leaving out saves: the time of a frame of every scene in every step, as
# it is, with --keep-all, and with --shadows off. Prints a table, and writes
# out/bench/saved.csv (or below BENCH_OUT).
#
# The maps are drawn in every frame (--redraw), as in a first frame or where
# everything moves: what a later frame saves by keeping them is not counted.
# The three take turns, and a ratio is the median of those of the rounds, for
# the machine may be slower in one round than in the next. With scenes as
# arguments: of these only.
#
# Exit status: 0 the claims hold, 1 one does not, 2 no place to write, 3 a
# program does not run.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin, "$FindBin::Bin/../lib";
use File::Path qw(make_path);
use VSM;
use Judge   qw(ratio);
use Measure qw(processors summarise times_of);

use constant {
    ROUNDS => 3,
    FRAMES => 11,
    NONE   => 1.05,    # of --shadows off, where nothing casts or is lit
    WALL   => 2,       # times faster before one wall of a room
};

my $folder = $ENV{BENCH_OUT} // root() . '/out/bench';
my $wall   = 'room:turn=-100';
my @none   = qw(empty unlit offstage);
my @scenes = (
    qw(teapot edge bleed thin fence grazing avenue stage crowd room),
    $wall, @none
);
my @size = qw(--size 640x360);
my @runs = (
    [ plan     => '--redraw' ],
    [ keep_all => '--keep-all' ],
    [ off      => '--shadows', 'off' ],
);

# {plan, keep_all, off}: a point for each.
sub measure {
    my ( $scene, $step ) = @_;
    my ( %points, %timed );
    for my $round ( 1 .. ROUNDS ) {
        for my $run ( $round % 2 ? @runs : reverse @runs ) {
            my ( $name, @options ) = @$run;
            my $point = $points{$name} //= {
                step    => $step,
                options => [ '--scene', $scene, @size, @options ]
            };
            push @{ $timed{$name} }, times_of( $point, $folder, FRAMES );
        }
    }
    summarise( $points{$_}, @{ $timed{$_} } ) for keys %points;
    return \%points;
}

# How much longer a frame takes with everything kept, and than unshadowed.
sub ratios {
    my ($points) = @_;
    return map { ratio( 'total', @$points{@$_} ) } [qw(keep_all plan)],
      [qw(plan off)];
}

sub print_head {
    my @processors = processors();
    printf "%s x %d, %s; milliseconds of a frame, medians\n", $processors[0],
      scalar @processors, "@size";
    printf "%-16s%5s%9s%11s%7s%9s%7s\n", qw(scene step plan keep-all times),
      'off', 'over';
    return;
}

sub print_row {
    my ( $scene, $step, $points, $faster, $over ) = @_;
    printf "%-16s%5d%9.2f%11.2f%7.2f%9.2f%7.2f\n", $scene, $step,
      ( map { $points->{$_}{total_ms} } qw(plan keep_all) ), $faster,
      $points->{off}{total_ms}, $over;
    return;
}

# [whether it holds, a line that says so], or nothing.
sub claim {
    my ( $scene, $step, $faster, $over ) = @_;
    if ( grep { $_ eq $scene } @none ) {
        return [
            $over <= NONE,
            sprintf '%s, step %d: over --shadows off: %.2f, at most %s',
            $scene, $step, $over, NONE
        ];
    }
    return if $scene ne $wall;
    return [
        $faster >= WALL,
        sprintf '%s, step %d: times faster than --keep-all: %.2f, at least %s',
        $scene,
        $step,
        $faster,
        WALL
    ];
}

sub main {
    my $text = "scene,step,plan_ms,keep_all_ms,times,off_ms,over\n";
    my @claims;
    make_path($folder);
    print_head();
    for my $scene ( @ARGV ? @ARGV : @scenes ) {
        for my $step ( 1 .. 5 ) {
            my $points = measure( $scene, $step );
            my @found  = ratios($points);
            print_row( $scene, $step, $points, @found );
            push @claims, claim( $scene, $step, @found );
            $text .= join( ',',
                $scene, $step,
                ( map { $points->{$_}{total_ms} } qw(plan keep_all) ),
                $found[0], $points->{off}{total_ms},
                $found[1] )
              . "\n";
        }
    }
    spew( "$folder/saved.csv", $text );
    print "\n", map { ( $_->[0] ? 'holds ' : 'FAILS ', "$_->[1]\n" ) } @claims;
    return grep( { !$_->[0] } @claims ) ? 1 : 0;
}

$| = 1;
my $status = eval { main() };
print STDERR "saved: $@" unless defined $status;
exit( $status // 3 );
