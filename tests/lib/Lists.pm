# The lists of files that the Makefiles make.
package Lists;

use strict;
use warnings;

use Exporter qw(import);
use VSM;

our @EXPORT = qw(make made_list);

# `make test` hands its own flags and options down; here is a make that
# somebody types.
sub make {
    local %ENV = %ENV;
    delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES STEP DEPS BUILD)};
    delete @ENV{qw(CFLAGS CXXFLAGS LDFLAGS)};
    return command( '/usr/bin/env', 'make', @_ );
}

# The words of a variable: made_list('base').
sub made_list {
    my ($name) = @_;
    my $run = make( '-s', '-C', root(), 'DEPS=no',
        "--eval=list: ; \@echo \$($name)", 'list' );
    return split ' ', $run->{out};
}

1;
