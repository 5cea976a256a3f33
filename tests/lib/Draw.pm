# For the tests of the command line: small pictures, and refusals.
package Draw;

use strict;
use warnings;

use Exporter qw(import);
use File::Temp qw(tempdir);
use Test::More;
use VSM;

our @EXPORT = qw(draw is_refused);

my $own = tempdir( CLEANUP => 1 );

# A small picture as PNG, or "" if the program fails. The arguments come last:
# of an option given twice the last one counts.
sub draw {
    my ( $step, @arguments ) = @_;
    my $file    = "$own/picture.png";
    my $run     = run_warm( $step, qw(--size 160x90 --output), $file,
        @arguments );
    my $picture = -e $file ? slurp($file) : '';
    unlink $file;
    return $picture if !$run->{status} && !$run->{signal};
    diag("step $step @arguments: $run->{err}");
    return '';
}

# One test: exit status 2, one line that matches every pattern, no file.
sub is_refused {
    my ( $step, $arguments, $patterns, $name ) = @_;
    return stops {
        run( $step, qw(--size 16x9 --output picture.png --dump dump),
            @$arguments )
    }
    2, $patterns, "step $step: $name is refused";
}

1;
