# Work on several processors: a child for each item, so many at a time.
package Workers;

use strict;
use warnings;

use Exporter qw(import);
use JSON::PP ();
use POSIX    ();

our @EXPORT_OK = qw(share_out);

my $JSON = JSON::PP->new->canonical->allow_nonref;

# A child that does the work; what it returns or dies of comes through a pipe.
sub begin {
    my ( $item, $work, $stopped ) = @_;
    my $child = open my $from, '-|';
    defined $child or die "cannot fork: $!\n";
    return { item => $item, from => $from } if $child;
    my $value = eval { $work->() };
    my %answer =
      defined $value ? ( value => $value ) : ( why => $@ =~ s/\n\z//r );
    $answer{stopped} = $$stopped;
    print $JSON->encode( \%answer );
    close STDOUT;
    POSIX::_exit(0);    # not exit: the END blocks are the parent's
}

# $work->($item, $slot) for each item, in `jobs` children at a time; a slot is
# a number below that. Then here, in the items' order, $take->($item, $value)
# or $take->($item, undef, $why). Where a child was told to stop, all are.
sub share_out {
    my ( $jobs, $items, $work, $take, $stopped ) = @_;
    my @running;
    my $next    = 0;
    my $collect = sub {
        my $oldest = shift @running;
        my $from   = $oldest->{from};
        local $/;
        my $text = <$from>;
        close $from;
        my $answer = eval { $JSON->decode($text) }
          // { why => 'the report\'s own child died' };
        $$stopped ||= $answer->{stopped};
        return if $$stopped;
        $take->( $oldest->{item}, @$answer{qw(value why)} );
    };
    while ( $next < @$items && !$$stopped ) {
        $collect->() if @running == $jobs;
        last         if $$stopped;
        my ( $item, $slot ) = ( $items->[$next], $next % $jobs );
        $next++;
        push @running,
          begin( $item, sub { $work->( $item, $slot ) }, $stopped );
    }
    $collect->() while @running;
    return;
}

1;
