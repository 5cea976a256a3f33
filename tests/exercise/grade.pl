#!/usr/bin/perl
# Marks for a step that somebody has written into the copy that `make exercise`
# made: each function on its own, in a program that is right otherwise; then the
# copy as a whole. Pictures go to DIR/grade/. Exit status 0 if all is right, 1
# if not, 2 if there is nothing to look at.
# usage: grade.pl STEP DIR
use strict;
use warnings;

use File::Compare qw(compare);
use File::Path    qw(make_path);
use File::Temp    qw(tempdir);
use FindBin;
use lib $FindBin::Bin, "$FindBin::Bin/../lib";
use Marks;
use Tasks;
use VSM;

# Not what `make grade` was told: the copy's make is another one.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};

my ( $step, $folder ) = @ARGV;

sub refuse {
    print STDERR @_, "\n";
    exit 2;
}

# Prints a verdict; returns whether it is good.
sub verdict {
    my ( $what, @wrong ) = @_;
    printf "%-6s %s\n", @wrong ? 'wrong' : 'right', $what;
    print "       $_\n" for @wrong;
    return !@wrong;
}

# Whether the copy builds, and draws what the right program draws.
sub whole {
    my $make = command( '/usr/bin/env', 'make', '-C', $folder, 'DEPS=no' );
    return 'it does not build', split /\n/, $make->{err} if $make->{status};
    my $work     = tempdir( CLEANUP => 1 );
    my @pictures = ( "$work/mine.png", "$work/right.png" );
    my @draw     = qw(--size 320x180 --output);
    my $mine     = command( "$folder/build/" . program_name($step),
        @draw, $pictures[0] );
    command( program($step), @draw, $pictures[1] );
    return if !$mine->{status} && compare(@pictures) == 0;
    my %task    = map { task_file( $step, $_ ) => 1 } tasks($step);
    my @changed = grep {
             /^step\d/
          && -f root() . "/$_"
          && !$task{$_}
          && compare( "$folder/$_", root() . "/$_" )
    } everything_below($folder);
    return 'it draws something else, though all functions are right',
      split( /\n/, $mine->{err} ), @changed ? "changed: @changed" : ();
}

refuse('say which and where: make grade STEP=5 DIR=mine')
  if !tasks( $step // '' ) || ( $folder // '' ) eq '';
for my $task ( tasks($step) ) {
    my $file = "$folder/" . task_file( $step, $task );
    refuse("there is no $file: make exercise STEP=$step DIR=$folder makes it")
      if !-f $file;
}
make_path("$folder/grade");
my $right = 0;
for my $task ( tasks($step) ) {
    my ($name) = $task->{file} =~ /^(\w+)/;
    my $file = task_file( $step, $task );
    $right += verdict( "$task->{function}, $file",
        mark( $step, $task, slurp("$folder/$file"), "$folder/grade/$name.png" )
    );
}
my $all = $right == tasks($step) && verdict( 'the whole program', whole() );
printf "%d of %d functions right\n", $right, scalar tasks($step);
exit( $all ? 0 : 1 );
