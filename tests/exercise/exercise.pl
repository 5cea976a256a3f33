#!/usr/bin/perl
# A step to be written: a stand-alone copy with empty functions (Lessons.pm).
# usage: exercise.pl STEP DIR
use strict;
use warnings;

use FindBin;
use lib $FindBin::Bin, "$FindBin::Bin/../lib";
use Submission qw(printable shell_word);
use Tasks;
use VSM;

# Not what `make exercise` was told: the copy's make is another one.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES)};

my ( $step, $folder ) = @ARGV;
if ( !tasks( $step // '' ) || ( $folder // '' ) eq '' ) {
    print STDERR "say which and where: make exercise STEP=5 DIR=mine\n";
    exit 2;
}
if ( -e $folder && ( !-d $folder || ( () = everything_below($folder) ) ) ) {
    print STDERR printable($folder),
      " is there already, and may be somebody's work: name a new folder\n";
    exit 2;
}
my $run = command( '/usr/bin/env', 'make', '-s', '-C', root(),
    'standalone', "STEP=$step", 'DIR=' . File::Spec->rel2abs($folder) );
if ( $run->{status} ) {
    print STDERR $run->{out}, $run->{err};
    exit 1;
}
for my $task ( tasks($step) ) {
    my $file = task_file( $step, $task );
    spew( "$folder/$file", emptied( $step, $task ) );
    print "to be written: $task->{function}\n    in ",
      printable("$folder/$file"), "\n";
}
my $shown = shell_word($folder);
print "make -C $shown\n",
  shell_word( "$folder/build/" . program_name($step) ), " --output mine.png\n",
  "make grade STEP=$step DIR=$shown\n";
