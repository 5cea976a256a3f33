# How far the measuring is, on stderr: a bar that rewrites its line on a
# terminal, else a line every tenth.
package Progress;

use strict;
use warnings;

use List::Util  qw(sum0);
use Time::HiRes qw(time);

# total: how many tasks of each kind are still to do; guess: seconds that one
# of a kind takes, until some have been done.
sub new {
    my ( $class, %total ) = @_;
    return bless {
        total => \%total,
        done  => { map { $_ => 0 } keys %total },
        begun => {},
        guess => { errors => 2, times => 1 },
        shown => -1,
        live  => -t STDERR,
      },
      $class;
}

# The first task of a kind begins.
sub begin {
    my ( $self, $kind ) = @_;
    $self->{begun}{$kind} //= time;
    $self->show($kind);
    return;
}

# A task of the kind is done; what is still to do is shown with its name.
sub done {
    my ( $self, $kind, $name ) = @_;
    $self->{done}{$kind}++;
    $self->{took}{$kind} = time - $self->{begun}{$kind};
    $self->show("$kind: $name");
    return;
}

sub left {
    my ( $self, $kind ) = @_;
    my $done = $self->{done}{$kind};
    my $each = $done ? $self->{took}{$kind} / $done : $self->{guess}{$kind};
    return $each * ( $self->{total}{$kind} - $done );
}

sub show {
    my ( $self, $name ) = @_;
    my $done  = sum0( values %{ $self->{done} } );
    my $total = sum0( values %{ $self->{total} } ) || 1;
    my $left  = sum0( map { $self->left($_) } keys %{ $self->{total} } );
    my $tenth = int( 10 * $done / $total );
    return if !$self->{live} && $tenth == $self->{shown};
    $self->{shown} = $tenth;
    my $width = int( 20 * $done / $total );
    printf STDERR "%s[%s%s] %d of %d, %d:%02d left, %-36.36s%s",
      $self->{live} ? "\r" : '', '#' x $width, '.' x ( 20 - $width ), $done,
      $total, $left / 60, $left % 60, $name, $self->{live} ? '' : "\n";
    return;
}

sub finish {
    my ($self) = @_;
    print STDERR "\r", ' ' x 79, "\r" if $self->{live};
    return;
}

1;
