#!/usr/bin/perl
# What leaving out saves: the time of a frame of every scene in every step, as
# it is, with --keep-all, and with --shadows off. Prints a table, and writes
# out/bench/saved.csv (or below BENCH_OUT).
#
# The maps are drawn in every frame (--redraw), as in a first frame or where
# everything moves: what a later frame saves by keeping them is not counted.
# To fit the views and to plan takes 0.01 to 6 ms more, most of it for the
# views, which all need. The three take turns, and what counts is the first
# quartile of each one's frames: whatever else the machine does mostly adds to a
# frame, but two threads that find both cores idle for once say nothing either.
# With scenes as arguments: of these only.
#
# A claim fails where it does so in three rounds of four too, by the fastest
# frames of each; else it is unclear, for the machine was busy.
#
# Exit status: 0 no claim fails, 1 one does, 2 no place to write, 3 a
# program does not run.
use strict;
use warnings;
use FindBin;
use lib $FindBin::Bin, "$FindBin::Bin/../lib";
use File::Path qw(make_path);
use VSM;
use Judge   qw(lies_between outcome);
use Measure qw(processors quantile summarise times_of);

use constant {
    ROUNDS => 3,
    MORE   => 9,       # rounds, of what something is claimed
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
    my $claimed = grep { $_ eq $scene } $wall, @none;
    for my $round ( 1 .. ( $claimed ? MORE : ROUNDS ) ) {
        for my $run ( $round % 2 ? @runs : reverse @runs ) {
            my ( $name, @options ) = @$run;
            my $point = $points{$name} //= {
                step    => $step,
                options => [
                    '--scene', $scene, @size, @options,
                    $step == 5 ? qw(--moments central) : ()
                ]
            };
            push @{ $timed{$name} }, times_of( $point, FRAMES );
        }
    }
    summarise( $points{$_}, @{ $timed{$_} } ) for keys %points;
    return \%points;
}

sub print_head {
    my @processors = processors();
    printf "%s x %d, %s; milliseconds of a frame, quartile\n", $processors[0],
      scalar @processors, "@size";
    printf "%-16s%5s%9s%11s%7s%9s%7s\n", qw(scene step plan keep-all times),
      'off', 'over';
    return;
}

sub print_row {
    my ( $scene, $step, $plan, $kept, $off ) = @_;
    printf "%-16s%5d%9.2f%11.2f%7.2f%9.2f%7.2f\n", $scene, $step, $plan,
      $kept, $kept / $plan, $off, $plan / $off;
    return;
}

# The ratio of two points' times; and its quartiles, round by round.
sub ratios {
    my ( $this, $that ) = @_;
    my ( $these, $those ) = map { $_->{fastest}{total} } $this, $that;
    my @ratios = map { $these->[$_] / $those->[$_] } 0 .. $#$these;
    return (
        $this->{total_q1} / $that->{total_q1},
        map { quantile( $_, @ratios ) } 0.25, 0.75
    );
}

# {holds, text}, or nothing.
sub claim {
    my ( $scene, $step, $points ) = @_;
    my ( $plan, $kept, $off ) = map { $points->{ $_->[0] } } @runs;
    if ( grep { $_ eq $scene } @none ) {
        my @over = ratios( $plan, $off );
        return {
            holds => scalar lies_between( 0, NONE, @over ),
            text  => sprintf
              '%s, step %d: over --shadows off: %.2f, at most %s',
            $scene, $step, $over[0], NONE
        };
    }
    return if $scene ne $wall;
    my @times = ratios( $kept, $plan );
    return {
        holds => scalar lies_between( WALL, 1e9, @times ),
        text  => sprintf
          '%s, step %d: times faster than --keep-all: %.2f, at least %s',
        $scene, $step, $times[0], WALL
    };
}

sub main {
    my $text = "scene,step,frame,median_ms,q1_ms,q3_ms\n";
    my @claims;
    make_path($folder);
    print_head();
    for my $scene ( @ARGV ? @ARGV : @scenes ) {
        for my $step ( 1 .. 5 ) {
            my $points = measure( $scene, $step );
            my @found  = map { $points->{ $_->[0] }{total_q1} } @runs;
            print_row( $scene, $step, @found );
            push @claims, claim( $scene, $step, $points );
            for my $run ( map { $_->[0] } @runs ) {
                my $point = $points->{$run};
                $text .= join( ',',
                    $scene, $step, $run,
                    @$point{qw(total_ms total_q1 total_q3)} )
                  . "\n";
            }
        }
    }
    spew( "$folder/saved.csv", $text );
    print "\n", map { ( outcome($_), " $_->{text}\n" ) } @claims;
    return grep( { outcome($_) eq 'FAILS' } @claims ) ? 1 : 0;
}

$| = 1;
my $status = eval { main() };
print STDERR "saved: $@" unless defined $status;
exit( $status // 3 );
