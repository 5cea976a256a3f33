# What a function that somebody has written is worth, and why.
package Marks;

use strict;
use warnings;

use Exporter      qw(import);
use File::Compare qw(compare);
use File::Temp    qw(tempdir);
use Tasks;
use VSM;

our @EXPORT = qw(mark);

our @SIZE = qw(--size 320x180 --map-size 256);

# Another way to compute the same: 16 roundings of 32-bit floats in [0, 1]. The
# oracle allows only what the formula as it stands here can lose.
my $ROUNDING = 2**-20;

my $work = tempdir( CLEANUP => 1 );
my %folders;    # with shaders, by what stands in them

# The dump of the right program, and of one that is right but for this text in
# the place of a task's file.
sub right_dump {
    my ( $step, $task ) = @_;
    return dump_run( $step, @SIZE, @{ $task->{options} } );
}

sub dump_with {
    my ( $step, $task, $text ) = @_;
    my $file   = task_file( $step, $task );
    my $folder = $folders{"$file\n$text"} //= "$work/" . keys %folders;
    spew( "$folder/$file", $text );
    return dump_run( $step, @SIZE, @{ $task->{options} },
        '--shaders', $folder );
}

# The lines in which the oracle objects.
sub objections {
    my ( $task, $dump ) = @_;
    my @objections;
    for ( @{ $task->{checks} } ) {
        my ( $check, $about ) = @$_;
        my @lines = grep { /^(?:PASS|FAIL) $about/ } split /\n/,
          ask_oracle( $check, $dump )->{out};
        @lines or die "$check says nothing about $task->{function}\n";
        push @objections, map { /^FAIL (.*)/ ? $1 : () } @lines;
    }
    return @objections;
}

# Between what two dumps show of a task: the largest difference and the RMSE.
# Nothing where there are values that are no numbers.
sub difference {
    my ( $task, @dumps ) = @_;
    my @files = map { "$_/$task->{shows}[0].exr" } @dumps;
    return ( 0, 0 ) if compare(@files) == 0;
    my $out = ask_oracle( 'compare', @files )->{out};
    return $out =~ /largest (\S+) .*RMSE (\S+),/;
}

# What somebody was thinking who gets this: of the known mistakes, and of
# nothing having been written, the one that gives nearly the same. The RMSE from
# what is right is `wrong`.
sub reason {
    my ( $step, $task, $dump, $wrong ) = @_;
    return 'There are values that are no numbers.' if !defined $wrong;
    my @known = (
        [ 'It is not written yet.', emptied( $step, $task ) ],
        map { [ $_->[0], mistaken( $step, $task, $_ ) ] }
          @{ $task->{mistakes} }
    );
    my ( $least, $words ) =
      ( 0.1 * $wrong, 'It is none of the mistakes that are known here.' );
    for my $mistake (@known) {
        my $other = dump_with( $step, $task, $mistake->[1] );
        my ( undef, $away ) = difference( $task, $dump, $other );
        next if !defined $away || $away > $least;
        ( $least, $words ) = ( $away, $mistake->[0] );
        last if $away == 0;
    }
    return $words;
}

# Yours, the right one, and the difference, which is `largest` somewhere. Returns
# a line that says so.
sub show {
    my ( $task, $picture, $largest, @dumps ) = @_;
    my ( $file, $channel ) = @{ $task->{shows} };
    my ( $mine, $right ) = map { "$_/$file.exr" } @dumps;
    my @one   = ( '--ch', $channel );
    my @grey  = ( @one, '--ch', '0,0,0', '--chnames', 'R,G,B' );
    my $scale = '0,0,1,1,1,1,1,0,0';    # blue, white, red
    my $run   = command(
        qw(/usr/bin/env oiiotool), $mine, @grey, $right, @grey,
        $mine, @one, $right, @one, '--sub',
        '--mulc', 0.5 / ( $largest // 1 ),
        qw(--addc 0.5 --colormap), $scale,
        qw(--mosaic:pad=4 3x1 -d uint8 -o), $picture
    );
    return if $run->{status} || !-e $picture;
    return "$picture: yours, the right one, and where yours is larger (red) "
      . 'or smaller (blue)'
      . ( defined $largest ? ", by up to $largest" : '' );
}

# Of a task whose file holds this text: what is wrong with it, line by line;
# nothing if it is right. The picture is written if it is wrong.
sub mark {
    my ( $step, $task, $text, $picture ) = @_;
    my $file = task_file( $step, $task );
    my $dump = eval { dump_with( $step, $task, $text ) };
    if ( !$dump ) {    # it does not compile, or does not come to an end
        my $said = $@ =~ s{\Q$work\E/\d+/}{}gr;
        my ( $run, @lines ) = reverse split /\n/, $said;
        return @lines ? reverse @lines : $run;
    }
    my @objections = objections( $task, $dump ) or return;
    my $right = right_dump( $step, $task );
    my ( $largest, $rmse ) = difference( $task, $dump, $right );
    return if defined $largest && $largest <= $ROUNDING;
    return (
        reason( $step, $task, $dump, $rmse ),
        $objections[0],
        defined $picture
        ? show( $task, $picture, $largest, $dump, $right )
        : ()
    );
}

1;
