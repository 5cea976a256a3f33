# What a failing check says besides its name: the line of the test that it
# comes from, the commands that it is about, to be repeated by hand, and of
# what was compared no more than fits a screen.
package Failing;

use strict;
use warnings;

use Exporter   qw(import);
use Test2::API qw(test2_stack);
use Test::More;

our @EXPORT_OK = qw(is_about made);

use constant {
    LINES   => 20,     # of a message
    LETTERS => 1000,   # of a line
    LAST    => 4,      # commands
};

my @commands;          # since the check before this one
my $checked = 0;
my %made;              # by folder: {name, command}

# These words were run: the next check, and those that follow without another
# command, are about them.
sub is_about {
    my @words = @_;
    @commands = () if $checked;
    $checked  = 0;
    my $command = line_of(@words);
    return if $command =~ /\n/;
    my @before = map { $made{$_}{command} }
      grep { my $folder = $_; grep { /\Q$folder\E/ } @words } sort keys %made;
    for my $new ( @before, $command ) {
        push @commands, $new unless grep { /\Q$new\E\z/ } @commands;
    }
    shift @commands while @commands > LAST;
    return;
}

# The same, of words that make a folder which will be gone by then.
sub made {
    my ( $folder, @words ) = @_;
    my $number = 1 + keys %made;
    $made{$folder} //= { name => "out/dump$number" };
    $made{$folder}{command} =
      "mkdir -p $made{$folder}{name} && " . line_of(@words);
    return is_about(@words);
}

sub named {
    my ($text) = @_;
    $text =~ s/\Q$_\E/$made{$_}{name}/g for keys %made;
    return $text;
}

# The words for a shell, in the root of the tree.
sub line_of {
    my @words = @_;
    for my $word (@words) {
        $word = named($word);
        $word =~ s{^\Q@{[VSM::root()]}\E/}{};
        $word =~ s/'/'\\''/g, $word = "'$word'"
          if $word !~ m{\A[\w./:=,+@%-]+\z};
    }
    return join ' ', @words;
}

# Where the test itself was when it called the check, however deep.
sub place {
    my ( $depth, $file, $line ) = 0;
    while ( my @frame = caller $depth++ ) { ( $file, $line ) = @frame[ 1, 2 ] }
    return ( $file, $line );
}

sub explained {
    my ( $file, $line ) = @_;
    my ( $test, $called ) = place();
    my $where =
        $file eq $test && $line != $called
      ? "$file line $line, called from line $called"
      : "$test line $called";
    my $again =
      @commands ? '  by hand: ' . join( ' && ', @commands ) . "\n" : '';
    return "at $where.\n$again";
}

# The first and the last lines of a long message.
sub short {
    my ($message) = @_;
    my @lines = split /\n/, $message, -1;
    s/\A(.{@{[LETTERS]}}).+/$1 .../ for @lines;
    my $more = @lines - LINES;
    splice @lines, LINES / 2, $more, "... $more lines ..." if $more > 0;
    return join "\n", @lines;
}

test2_stack()->top->filter(
    sub {
        my ( undef, $event ) = @_;
        $checked = 1 if $event->isa('Test2::Event::Ok');
        return $event unless $event->isa('Test2::Event::Diag');
        my $message = short( named( $event->message ) );
        $message =~ s/\A( +Failed.*?)(\s+)at ([^\n]+) line (\d+)\.\n\z/
          $1 . $2 . explained( $3, $4 )/es;
        $event->set_message($message);
        return $event;
    },
    inherit => 1
);

1;
