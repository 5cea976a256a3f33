# What a function that somebody has written is worth, and why.
package Marks;

use strict;
use warnings;

use Config        qw(%Config);
use Exporter      qw(import);
use File::Compare qw(compare);
use File::Path    qw(make_path);
use File::Temp    qw(tempdir);
use List::Util    qw(first);
use Submission    qw(printable);
use Tasks;
use VSM;

our @EXPORT = qw(mark mark_whole);

our @SIZE = qw(--size 320x180 --map-size 256);

# What a run may use, besides VSM::SECONDS: 1 GB of memory, but for a sanitizer,
# which reserves all there is, and 64 MiB for each file. It ends with this
# process.
my @LIMITS = (
    qw(/usr/bin/env setpriv --pdeathsig KILL prlimit --fsize=67108864),
    $ENV{VSM_SLOW} ? '--core=0' : qw(--core=0 --as=1000000000)
);

# Another way to compute the same: 16 roundings of 32-bit floats in [0, 1]. The
# oracle allows only what the formula as it stands here can lose.
my $ROUNDING = 2**-20;

# What was not computed by the student's function can be rounded otherwise too,
# where the compiler arranges the shader in another way.
my $ELSEWHERE = 2**-16;

# A difference that an 8-bit picture shows.
my $VISIBLE = 1 / 255;

my $work = tempdir( CLEANUP => 1 );
my %runs;    # by step, options and shaders

# A run of the right program with these texts in the place of its shaders:
# {folder} with its dump, {said} if it did not come to its end.
sub drawn {
    my ( $step, $options, %texts ) = @_;
    my $key = join "\0", $step, @$options,
      map { ( $_, $texts{$_} ) } sort keys %texts;
    return $runs{$key} if $runs{$key};
    my $folder = "$work/" . keys %runs;
    make_path( "$folder/shaders/step1_shadowmap", "$folder/dump" );
    spew( "$folder/shaders/$_", $texts{$_} ) for keys %texts;
    my $run = command(
        @LIMITS, program($step), @SIZE, @$options,
        '--shaders', "$folder/shaders",
        '--dump',    "$folder/dump",
        '--output',  "$folder/dump/picture.exr"
    );
    my @said = said( $run, "$folder/shaders/" );
    return $runs{$key} = { folder => "$folder/dump", said => \@said };
}

# In words: why a run failed.
sub said {
    my ( $run, $folder ) = @_;
    my $signal = $run->{signal};
    return "It took longer than $VSM::SECONDS s: does a loop never end?"
      if $signal == 14;
    return 'It was stopped by signal '
      . "$signal (" . ( split ' ', $Config{sig_name} )[$signal] . '): '
      . 'does it need more than 1 GB, or nest too deeply?'
      if $signal;
    return if !$run->{status};
    my @lines = grep { /\S/ } split /\n/, $run->{err} =~ s/\Q$folder\E//gr;
    splice @lines, 5;
    return @lines ? map { printable($_) } @lines : "exit status $run->{status}";
}

# The dump of the program with nothing in the place of its shaders.
sub right_dump {
    my ( $step, $options ) = @_;
    my $run = drawn( $step, $options );
    die "the right program does not draw: @{ $run->{said} }\n"
      if @{ $run->{said} };
    return $run->{folder};
}

# The lines in which the oracle objects.
sub objections {
    my ( $task, $dump ) = @_;
    my @objections;
    for ( @{ $task->{checks} } ) {
        my ( $check, $about ) = @$_;
        my @lines = grep { /^(?:PASS|FAIL) $about/ } split /\n/,
          ask_oracle( $check, $dump )->{out};
        push @objections,
          @lines
          ? map { /^FAIL (.*)/ ? $1 : () } @lines
          : "$check: there is nothing to check";
    }
    return @objections;
}

# Between two pictures: the largest difference and the RMSE. Nothing where there
# are values that are no numbers.
sub difference {
    my @files = @_;
    return ( 0, 0 ) if compare(@files) == 0;
    my $out = ask_oracle( 'compare', @files )->{out};
    return $out =~ /largest (\S+) .*RMSE (\S+),/;
}

# The same between what two dumps show of a task, and the file of it in which
# they differ most.
sub difference_shown {
    my ( $task, @dumps ) = @_;
    my @most = (-1);
    for my $file ( grep { /^$task->{shows}[0]\b.*exr$/ }
        everything_below( $dumps[1] ) )
    {
        my ( $largest, $rmse ) = difference( map { "$_/$file" } @dumps );
        return ( undef, undef, $file ) if !defined $largest;
        @most = ( $largest, $rmse, $file ) if $largest > $most[0];
    }
    return @most;
}

# The first file in which the dumps may not differ and do: what is drawn covers
# other pixels, or hides other surfaces.
sub moved {
    my ( $task, $dump, $right ) = @_;
    return first {
        my ($largest) = difference( "$dump/$_", "$right/$_" );
        !defined $largest || $largest > $ELSEWHERE
    }
    grep { /$task->{same}/ } everything_below($right);
}

# What somebody was thinking who gets this: of the known mistakes, and of
# nothing having been written, the one that gives nearly the same. The RMSE from
# what is right is `wrong`. Nothing where no mistakes are known.
sub reason {
    my ( $step, $task, $dump, $wrong ) = @_;
    return 'There are values that are no numbers.' if !defined $wrong;
    return if !$task->{mistakes};
    my @known = (
        [ 'It is not written yet.', emptied( $step, $task ) ],
        map { [ $_->[0], mistaken( $step, $task, $_ ) ] }
          @{ $task->{mistakes} }
    );
    my ( $least, $words ) =
      ( 0.1 * $wrong, 'It is none of the mistakes that are known here.' );
    for my $mistake (@known) {
        my $other = drawn( $step, $task->{options},
            task_file( $step, $task ) => $mistake->[1] );
        my ( undef, $away ) =
          difference_shown( $task, $dump, $other->{folder} );
        next if !defined $away || $away > $least;
        ( $least, $words ) = ( $away, $mistake->[0] );
        last if $away == 0;
    }
    return $words;
}

# Yours, the right one, and the difference of a file, which is `largest`
# somewhere, as the bytes of a PNG, and a line that says so; nothing if it
# cannot be made.
sub shown {
    my ( $task, $largest, $file, @dumps ) = @_;
    my $channel = $task->{shows}[1];
    my ( $mine, $right ) = map { "$_/$file" } @dumps;
    my @one   = ( '--ch', $channel );
    my @grey  = ( @one, '--ch', '0,0,0', '--chnames', 'R,G,B' );
    my $scale = '0,0,1,1,1,1,1,0,0';    # blue, white, red
    my $run   = command(
        qw(/usr/bin/env oiiotool), $mine, @grey, $right, @grey,
        $mine, @one, $right, @one, '--sub',
        '--mulc', 0.5 / ( $largest || 1 ),
        qw(--addc 0.5 --colormap), $scale,
        qw(--mosaic:pad=4 3x1 -d uint8 -o), "$work/shown.png"
    );
    return if $run->{status} || !-e "$work/shown.png";
    return slurp("$work/shown.png"),
      'yours, the right one, and where yours is larger (red) '
      . 'or smaller (blue)'
      . ( defined $largest ? ", by up to $largest" : '' );
}

# Of a task whose file holds this text: what is wrong with it, line by line;
# nothing if it is right, in all its runs. Where something wrong was drawn, the
# code gets the picture's bytes and the words for it, and returns a line.
sub mark {
    my ( $step, $task, $text, $keep ) = @_;
    return 'It holds a byte 0: it is no text.' if $text =~ /\0/;
    my @wrong = mark_run( $step, $task, $text, $keep );
    return @wrong if @wrong;
    for ( @{ $task->{also} } ) {
        my %run = ( %$task, mistakes => undef, %$_ );
        @wrong = mark_run( $step, \%run, $text, $keep ) or next;
        return ( fixed( $task->{options}, $run{options} ), @wrong );
    }
    return;
}

# In words: what is right with these options and wrong with those.
sub fixed {
    my @options = map { @$_ ? "@$_" : 'the default options' } @_;
    return "It is right with $options[0], and wrong with $options[1]: "
      . 'what is fixed in it that is another there, a size, a layer, '
      . 'a constant?';
}

# The same of the one run with the task's options.
sub mark_run {
    my ( $step, $task, $text, $keep ) = @_;
    my $right = right_dump( $step, $task->{options} );
    my $run =
      drawn( $step, $task->{options}, task_file( $step, $task ) => $text );
    return @{ $run->{said} } if @{ $run->{said} };
    my $dump       = $run->{folder};
    my ( $largest, $rmse, $file ) = difference_shown( $task, $dump, $right );
    my @objections =
      defined $largest && $largest <= $ROUNDING
      ? ()
      : objections( $task, $dump );
    my @wrong;
    if ( !@objections ) {
        my $moved = moved( $task, $dump, $right ) // return;
        @wrong = (
            'It does not draw the same pixels as the right one: it leaves '
              . 'some out (discard), or changes what hides them '
              . '(gl_FragDepth).',
            "other values than in the right program: $moved"
        );
    }
    else {
        @wrong = ( reason( $step, $task, $dump, $rmse ), $objections[0] );
    }
    my @picture =
      $keep ? shown( $task, $largest, $file, $dump, $right ) : ();
    return ( @wrong, @picture ? $keep->(@picture) : () );
}

# Of a program with these texts in the place of its shaders, as a whole.
sub mark_whole {
    my ( $step, %texts ) = @_;
    my ($first) = tasks($step);
    for my $options ( [], map { $_->{options} } @{ $first->{also} } ) {
        my $right = right_dump( $step, $options );
        my $run   = drawn( $step, $options, %texts );
        return @{ $run->{said} } if @{ $run->{said} };
        my ($largest) =
          difference( map { "$_/picture.exr" } $run->{folder}, $right );
        next if defined $largest && $largest <= $VISIBLE;
        return 'It draws something else, though all functions are right.',
          @$options ? "with @$options" : ();
    }
    return;
}

1;
