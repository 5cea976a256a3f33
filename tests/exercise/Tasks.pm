# The functions of an exercise (Lessons.pm), as text: emptied, and mistaken.
package Tasks;

use strict;
use warnings;

use Exporter   qw(import);
use Lessons    qw(%LESSONS);
use Plant      qw(planted);
use Text::Wrap qw(wrap);
use VSM        qw(program_name root slurp);

our @EXPORT = qw(tasks task_file emptied mistaken);

sub tasks {
    my ($step) = @_;
    return @{ $LESSONS{$step} // [] };
}

# From the tree's top, or from that of a stand-alone copy.
sub task_file {
    my ( $step, $task ) = @_;
    return program_name($step) . "/shaders/$task->{file}";
}

# The file's text with nothing but its task left in the function.
sub emptied {
    my ( $step, $task ) = @_;
    my $text = slurp( root() . '/' . task_file( $step, $task ) );
    local $Text::Wrap::columns = 81;
    my $words = wrap( ('    // ') x 2, "YOURS. $task->{words}" );
    my $heading = join '\s+', map { quotemeta } split ' ', $task->{function};
    $text =~ s/^($heading\n\{\n).*?^\}/$1$words\n    $task->{empty}\n}/ms
      or die "$task->{file} has no $task->{function}\n";
    return $text;
}

# The file's text with one of the task's mistakes.
sub mistaken {
    my ( $step, $task, $mistake ) = @_;
    my $text = slurp( root() . '/' . task_file( $step, $task ) );
    my ( undef, @pairs ) = @$mistake;
    return planted( $task->{file}, $text, @pairs );
}

1;
