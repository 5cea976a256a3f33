# Files that have to hold the same values to the last bit.
package Same;
use strict;
use warnings;
use Exporter qw(import);
use Test::More;
use File::Temp;
use VSM qw(oracle);

our @EXPORT = qw(same_files same_channel);

# Each named EXR file of two dumps. `oracle compare` counts values that are
# not finite first: comparing alone would call them equal.
sub same_files {
    my ( $what, $one, $other, @names ) = @_;
    for my $name (@names) {
        note("$what: $name");
        oracle( 'compare', "$one/$name.exr", "$other/$name.exr", 'max=0' );
    }
    return;
}

# The first channel of two EXR files.
sub same_channel {
    my ( $what, $one, $other ) = @_;
    my $folder = File::Temp->newdir;
    my @copies;
    for my $file ( $one, $other ) {
        my $copy = "$folder/" . @copies . '.exr';
        system( 'oiiotool', $file, '--ch', '0', '-d', 'float', '-o', $copy ) == 0
          or return fail("$what: oiiotool cannot read $file");
        push @copies, $copy;
    }
    note($what);
    oracle( 'compare', @copies, 'max=0' );
    return;
}

1;
