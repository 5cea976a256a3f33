#!/usr/bin/perl
# Marks for a step that somebody has written into the copy that `make exercise`
# made: each function on its own, in a program that is right otherwise; then the
# program with all shaders that were changed. Nothing of the copy is run but
# shaders, under limits of time and memory. Pictures go to DIR/grade/. Exit
# status 0 if all is right, 1 if not, 2 if there is nothing to look at.
# usage: grade.pl STEP DIR
use strict;
use warnings;

use File::Spec;
use FindBin;
use lib $FindBin::Bin, "$FindBin::Bin/../lib";
use Marks;
use Submission;
use Tasks;
use VSM;

my $LONGEST_SHADER = ( 1 << 14 ) - 1;    # as in base/gl/shader_file.c

my ( $step, $folder ) = @ARGV;

# What is told to stop takes along what it runs, and its temporary files.
for my $signal (qw(HUP INT PIPE TERM USR1 USR2 QUIT)) {
    $SIG{$signal} = sub {
        kill 'KILL', $VSM::running if $VSM::running;
        exit 1;
    };
}
$| = 1;

sub refuse {
    print STDERR printable("@_"), "\n";
    exit 2;
}

# Prints a verdict; returns whether it is good.
sub verdict {
    my ( $what, @wrong ) = @_;
    printf "%-6s %s\n", @wrong ? 'wrong' : 'right', $what;
    print "       $_\n" for @wrong;
    return !@wrong;
}

# What is wrong with one function, line by line.
sub mark_function {
    my ($task) = @_;
    my $file = task_file( $step, $task );
    my $text = eval { read_plain( $folder, $file, $LONGEST_SHADER ) };
    return "missing: make exercise STEP=$step DIR=another makes it again"
      if $@ eq "missing\n";
    return $@ =~ s/\n//r if $@;
    my ($name) = $task->{file} =~ /^(\w+)/;
    return mark(
        $step, $task, $text,
        sub {
            my ( $bytes, $words ) = @_;
            eval { keep_picture( $folder, "$name.png", $bytes ); 1 }
              or return "no picture: " . $@ =~ s/\n//r;
            return printable("$folder/grade/$name.png") . ": $words";
        }
    );
}

# The files of the copy as `make exercise` made them, but for the functions.
sub known_files {
    my %known;
    for my $name ( map { program_name($_) } 1 .. $step ) {
        my $folder = root() . "/$name";
        for my $file ( everything_below($folder) ) {
            $known{"$name/$file"} = slurp("$folder/$file")
              if -f "$folder/$file";
        }
    }
    $known{Makefile} =
      "ROOT := .\ninclude " . program_name($step) . "/Makefile\n";
    return %known;
}

# What is not as in them: the texts of shaders by name, and the names of those
# that are not looked at.
sub changes {
    my ( %shaders, @others );
    my %known = known_files();
    my %task  = map { task_file( $step, $_ ) => 1 } tasks($step);
    for my $file ( sort keys %known ) {
        my $shader = $file =~ /\.(?:glsl|vert|geom|frag|comp)$/;
        my $most   = $shader ? $LONGEST_SHADER : length $known{$file};
        my $text   = eval { read_plain( $folder, $file, $most ) };
        next if defined $text ? $text eq $known{$file} : $@ eq "missing\n";
        if   ( $shader && defined $text ) { $shaders{$file} = $text }
        elsif ( !$task{$file} )           { push @others, $file }
    }
    return ( \%shaders, @others );
}

# Whether the changed shaders together draw what the right program draws.
sub mark_program {
    my ($shaders) = @_;
    my @wrong = mark_whole( $step, %$shaders ) or return;
    my %task    = map { task_file( $step, $_ ) => 1 } tasks($step);
    my @changed = grep { !$task{$_} } sort keys %$shaders;
    return @wrong, @changed ? "changed: @changed" : ();
}

refuse('say which and where: make grade STEP=5 DIR=mine')
  if !tasks( $step // '' ) || ( $folder // '' ) eq '';
refuse("there is no folder $folder: make exercise STEP=$step DIR=$folder "
      . 'makes it' )
  if !-d $folder;
$folder = File::Spec->rel2abs($folder);    # without a / at its end
refuse("$folder is a link: name the folder that it leads to") if -l $folder;
forget_picture( $folder, $_->{file} =~ s/\..*/.png/r ) for tasks($step);
my ( $shaders, @others ) = changes();
my $right = 0;
for my $task ( tasks($step) ) {
    my @wrong = eval { mark_function($task) };
    refuse("cannot mark: $@") if $@;
    $right += verdict( "$task->{function}, " . task_file( $step, $task ),
        @wrong );
}
my $all = $right == tasks($step)
  && verdict( 'the whole program', mark_program($shaders) );
print "changed, not looked at: @others\n" if @others;
printf "%d of %d functions right\n", $right, scalar tasks($step);
exit( $all ? 0 : 1 );
