# What `make bench` measures: sweeps, in each of which one number grows and all
# else stays; and claims about the ratio of two times.
package Bench;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(@SWEEPS @CLAIMS @GROWTHS points);

my @SMALL = qw(--size 320x180);
my @VSM   = qw(--moments central);

# A sweep: the number, its unit, its values, and the runs. A run: its name, its
# step, its options at a value, and the passes, each with a line in the table;
# `+` adds passes up. The pass that draws the map is `map` in every step.
our @SWEEPS = (
    {
        name   => 'width',
        unit   => 'texels of the filter, n = 2 radius + 1',
        values => [ map { 2 * $_ + 1 } 1, 2, 4, 8, 16, 32, 64 ],
        runs   => [
            {
                name    => 'PCF',
                step    => 2,
                options => sub { ( @SMALL, '--kernel', $_[0] ) },
                passes  => ['shading'],
            },
            {
                name    => 'VSM, box',
                step    => 5,
                options =>
                  sub { ( @SMALL, @VSM, '--radius', ( $_[0] - 1 ) / 2 ) },
                passes  => ['blur+shading'],
            },
            {
                name    => 'VSM, boxes',
                step    => 5,
                options => sub {
                    ( @SMALL, @VSM, '--blur', 'boxes', '--radius',
                        ( $_[0] - 1 ) / 2 );
                },
                passes => ['blur+shading'],
            },
            {
                name    => 'VSM, Gaussian',
                step    => 5,
                options => sub {
                    (
                        @SMALL, @VSM, '--blur', 'gaussian', '--radius',
                        ( $_[0] - 1 ) / 2
                    );
                },
                passes => ['blur+shading'],
            },
            {
                name    => 'VSM, table',
                step    => 5,
                options =>
                  sub { ( @SMALL, '--sat', '--radius', ( $_[0] - 1 ) / 2 ) },
                passes => ['blur+shading'],
            },
        ],
    },
    {
        name   => 'map',
        unit   => 'texels along a side',
        values => [ map { 2**$_ } 8 .. 13 ],
        runs   => [
            {
                name    => 'hard',
                step    => 1,
                options => sub { ( @SMALL, '--map-size', $_[0] ) },
                passes  => [qw(map shading)],
            },
            {
                name    => 'VSM',
                step    => 5,
                options => sub { ( @SMALL, @VSM, '--map-size', $_[0] ) },
                passes  => [qw(map blur shading)],
            },
        ],
    },
    {
        name   => 'triangles',
        unit   => 'triangles of the crowd',
        values => [ map { 10**$_ } 3 .. 7 ],
        runs   => [
            map {
                my ( $name, @more ) = @$_;
                {
                    name    => $name,
                    step    => 5,
                    options => sub {
                        ( @SMALL, '--scene', "crowd:triangles=$_[0]", @more );
                    },
                    passes =>
                      [ "@more" =~ /off/ ? 'shading' : qw(map shading) ],
                }
            } [ 'VSM', @VSM ],
            [qw(unshadowed --shadows off)]
        ],
    },
    {
        name   => 'picture',
        unit   => 'pixels of the picture',
        values => [ map { 16 * 9 * $_**2 } 20, 40, 80, 120, 160, 240 ],
        runs   => [
            map {
                my ( $name, $step, @more ) = @$_;
                {
                    name    => $name,
                    step    => $step,
                    options => sub {
                        my $sixteenth = sqrt( $_[0] / 16 / 9 );
                        my $size      = 16 * $sixteenth . 'x' . 9 * $sixteenth;
                        ( '--size', $size, @more );
                    },
                    passes => ['shading'],
                }
            } [ 'PCF 7', 2 ],
            [ 'VSM', 5, @VSM ],
            [qw(unshadowed 5 --shadows off)]
        ],
    },
    {
        name   => 'layers',
        unit   => 'splits of the avenue',
        values => [ 1, 2, 4, 6, 8 ],
        runs   => [
            {
                name    => 'VSM',
                step    => 5,
                options =>
                  sub {
                    ( @SMALL, @VSM, qw(--scene avenue --splits), $_[0] );
                  },
                passes => [qw(map blur shading)],
            },
        ],
    },
);

# Between the widest filter and the one before it PCF's n^2 has left behind
# what does not grow; a VSM's running boxes do not grow at all.
our @GROWTHS = (
    { sweep => 'width', run => 'PCF',        least => 1.8 },
    { sweep => 'width', run => 'VSM, box',   most  => 0.3 },
    { sweep => 'width', run => 'VSM, boxes', most  => 0.3 },
    { sweep => 'width', run => 'VSM, table', most  => 0.3 },
);

my @LARGE = qw(--size 160x90 --map-size 1024);
my @CROWD = ( @VSM, qw(--scene crowd:triangles=200000 --size 1920x1080
      --map-size 1024) );

# Radius 64 over radius 2.
sub wide_blur {
    my ( $text, @options ) = @_;
    return (
        text => "blur of 1024^2, $text",
        pass => 'blur',
        runs => [ map { [ 5, @LARGE, @options, '--radius', $_ ] } 64, 2 ],
    );
}

my $FRAME = 'crowd of 200,000 triangles, 1920x1080, map 1024^2: frame with VSM';

# How often a pass of one run fits into another's is at most `most`, or should
# be at most `aim`: the README says what is in the way.
our @CLAIMS = (
    (
        map {
            my ( $name, @kernel ) = @$_;
            +{
                wide_blur(
                    "$name in compute: radius 64 over radius 2",
                    '--blur-by', 'compute', @kernel
                ),
                aim => 1.3,
            }
        } [ 'box', @VSM ],
        [ 'boxes', @VSM, qw(--blur boxes) ],
        [ 'box of raw moments', qw(--moments raw) ]
    ),
    (
        map {
            my ( $name, @kernel ) = @$_;
            +{
                wide_blur(
                    "$name: radius 64 in compute over 2 in fragments",
                    @kernel
                ),
                most => 1.3,
            }
        } [ 'box', @VSM ],
        [ 'boxes', @VSM, qw(--blur boxes) ],
    ),
    {
        text => 'table of 1024^2: running sums over recursive doubling',
        pass => 'blur',
        runs => [
            map { [ 5, @LARGE, '--sat', '--sat-by', $_ ] }
              qw(compute fragments)
        ],
        most => 0.2,
    },
    {
        text => "$FRAME over --shadows off",
        pass => 'total',
        runs => [ map { [ 5, @CROWD, '--shadows', $_ ] } qw(on off) ],
        aim  => 1.8,
    },
    {
        text      => "$FRAME, unchanged scene, over --shadows off",
        pass      => 'total',
        runs      => [ map { [ 5, @CROWD, '--shadows', $_ ] } qw(on off) ],
        unchanged => 1,
        aim       => 1.15,
    },
);

# Every point of the sweeps, and two for each claim: {sweep, run, value, step,
# options}, in the order in which they take turns.
sub points {
    my @points;
    for my $sweep (@SWEEPS) {
        for my $value ( @{ $sweep->{values} } ) {
            for my $run ( @{ $sweep->{runs} } ) {
                push @points,
                  {
                    sweep   => $sweep->{name},
                    run     => $run->{name},
                    value   => $value,
                    step    => $run->{step},
                    options => [ $run->{options}->($value) ],
                  };
            }
        }
    }
    for my $claim (@CLAIMS) {
        for ( 0, 1 ) {
            my ( $step, @options ) = @{ $claim->{runs}[$_] };
            push @points,
              {
                sweep     => 'claim',
                run       => $claim->{text},
                value     => $_,
                step      => $step,
                options   => \@options,
                unchanged => $claim->{unchanged},
              };
        }
    }
    return @points;
}

1;
