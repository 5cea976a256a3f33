# What is left out changes no pixel: the same bytes with and without --keep-all,
# of the picture and of everything that it was made from. The maps under it are
# not compared: a dump draws them whole. VSM_ALL=1 (make identical): every scene
# in every step.
use strict;
use warnings;
use Test::More;
use VSM;

my @small = qw(--size 160x90 --map-size 128);
my @files = qw(picture image visibility receiver position normal);

# One test: the pictures of a run and of the same with --keep-all.
sub same_pixels {
    my ( $step, @options ) = @_;
    my $with    = dump_run( $step, @small, @options );
    my $without = dump_run( $step, @small, @options, '--keep-all' );
    my @differ =
      grep { slurp("$with/$_.exr") ne slurp("$without/$_.exr") } @files;
    is( "@differ", '', "step $step @options: the same pixels" );
    return;
}

my @scenes = qw(teapot edge bleed empty thin fence grazing avenue stage room
  crowd:triangles=3000 unlit offstage);
my @few = qw(room offstage unlit);

for my $step ( 1 .. 5 ) {
    my $all = $ENV{VSM_ALL} || $step == 5;
    same_pixels( $step, '--scene', $_ ) for $all ? @scenes : @few;
}
same_pixels( $_, '--scene', 'avenue:turn=40', qw(--splits 4) ) for 2, 5;
for my $light (qw(spot point)) {
    same_pixels( 5, '--light', $light, '--scene', $_ ) for qw(empty offstage);
}

done_testing;
