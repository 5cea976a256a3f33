# Reads and writes in a folder that somebody else has filled. Nothing in it is
# trusted: only plain files are read, and no link below the folder is followed.
package Submission;

use strict;
use warnings;

use Encode qw(FB_DEFAULT decode encode);
use Exporter qw(import);
use Fcntl qw(O_CREAT O_DIRECTORY O_EXCL O_NOFOLLOW O_NONBLOCK O_RDONLY
  O_WRONLY);
use File::Basename qw(basename dirname);

our @EXPORT = qw(read_plain keep_picture forget_picture printable
  shell_word);

# Runs the code in a folder below `top`, and comes back. Each folder is opened
# from the one above it, so nothing can be exchanged between check and use.
sub inside {
    my ( $top, $path, $code ) = @_;
    opendir my $home, '.' or die "cannot read the working folder: $!\n";
    my $result = eval {
        enter( $top, 0 );
        enter( $_,   O_NOFOLLOW ) for grep { $_ ne '.' } split m{/}, $path;
        $code->();
    };
    my $wrong = $@;
    chdir $home or die "cannot go back to the working folder: $!\n";
    die $wrong if $wrong;
    return $result;
}

sub enter {
    my ( $name, $flags ) = @_;
    my $folder;
    return
      if sysopen( $folder, $name, O_RDONLY | O_DIRECTORY | $flags )
      && chdir $folder;
    die "missing\n" if $!{ENOENT};
    die printable($name), " is no folder that can be read, or a link\n";
}

# The text of a plain file of at most so many bytes. Dies with "missing", or
# with what is wrong.
sub read_plain {
    my ( $top, $path, $most ) = @_;
    my $name = basename($path);
    return inside(
        $top,
        dirname($path),
        sub {
            lstat $name or die "missing\n";
            -f _ or die "it is no plain file (links are not followed)\n";
            sysopen my $file, $name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK
              or die "it cannot be read: $!\n";
            -f $file or die "it is no plain file\n";
            my $length = sysread( $file, my $text, $most + 1 )
              // die "it cannot be read: $!\n";
            die "it is over $most bytes\n" if $length > $most;
            return $text;
        }
    );
}

# Removes what an earlier run left as grade/NAME, or the link of that name.
sub forget_picture {
    my ( $top, $name ) = @_;
    return eval { inside( $top, 'grade', sub { unlink $name } ) };
}

# Makes grade/NAME of these bytes: always a new file, so that nothing is written
# through a link of that name. Another marking may do the same: the last one's
# stays.
sub keep_picture {
    my ( $top, $name, $bytes ) = @_;
    inside( $top, '.', sub { mkdir 'grade' } );
    return inside(
        $top, 'grade',
        sub {
            my ( $file, $new ) = ( undef, ".$name.$$" );
            sysopen( $file, $new, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW )
              && print( {$file} $bytes )
              && close($file)
              && rename( $new, $name )
              or die "cannot write grade/$name: $!\n";
        }
    );
}

# One line that shows nothing but letters: no line ends, no escape sequences of
# a terminal, no characters that change the direction of writing.
sub printable {
    my ($bytes) = @_;
    my $text = decode( 'UTF-8', $bytes, FB_DEFAULT );
    $text =~ s/[\p{C}\p{Zl}\p{Zp}]/?/g;
    $text =~ s/^(.{300}).+/$1.../;
    return encode( 'UTF-8', $text );
}

# A name of a file as a shell reads it, for a command that is shown.
sub shell_word {
    my ($name) = @_;
    $name = "./$name" if $name =~ /^-/;
    return $name      if $name =~ m{^[\w./+-]+$};
    return printable( "'" . $name =~ s/'/'\\''/gr . "'" );
}

1;
