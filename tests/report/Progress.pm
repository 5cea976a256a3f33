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
    my %guess = ( errors => 3, times => 1.5 );
    return bless {
        total => \%total,
        done  => { map { $_ => 0 } keys %total },
        spent => { map { $_ => 0 } keys %total },
        guess => \%guess,
        shown => -1,
        live  => -t STDERR,
      },
      $class;
}

sub left {
    my ( $self, $kind )  = @_;
    my ( $done, $spent ) = ( $self->{done}{$kind}, $self->{spent}{$kind} );
    my $each = $done ? $spent / $done : $self->{guess}{$kind};
    return $each * ( $self->{total}{$kind} - $done );
}

# Runs a task of one kind, and shows it by its name.
sub task {
    my ( $self, $kind, $name, $work ) = @_;
    $self->show("$kind: $name");
    my $start = time;
    my $value = $work->();
    $self->{spent}{$kind} += time - $start;
    $self->{done}{$kind}++;
    return $value;
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
