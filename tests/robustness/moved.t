# A tree that was copied or moved after it was built uses its own shaders, not
# those of the tree that it comes from.
use strict;
use warnings;

use Cwd        qw(abs_path);
use File::Path qw(make_path remove_tree);
use File::Temp qw(tempdir);
use Test::More;
use VSM;

my $work = abs_path( tempdir( CLEANUP => 1 ) );
chdir $work or die "cannot work in a temporary folder\n";

my $name  = program_name(1);
my @small = qw(--size 16x9 --output);

# A tree of step 1 with the program at this place in it; all is blue in it.
sub plant {
    my ( $tree, $place ) = @_;
    make_path( "$tree/$name", "$tree/$place" );
    for my $folder ( "$name/shaders", "$name/base/picture/shaders" ) {
        make_path("$tree/$folder");
        command( qw(cp -rT), root() . "/$folder", "$tree/$folder" );
    }
    command( 'cp', program(1), "$tree/$place" );
    my $shader = "$tree/$name/shaders/scene.frag";
    spew( $shader, slurp($shader) =~ s/= albedo \*/= albedo.bgr */r );
    return;
}

# The bytes that a program draws, or what it says.
sub drawn {
    my ($program) = @_;
    my $run = command( $program, @small, 'a.png' );
    return $run->{err} if $run->{status};
    my $bytes = slurp('a.png');
    unlink 'a.png';
    return $bytes;
}

my $ours = drawn( program(1) );
my $blue;
for my $place ( 'build', 'build/warm', 'build/sanitize/warm' ) {
    plant( "it's a copy", $place );
    $blue //= drawn("it's a copy/$place/$name");
    ok( png_size($blue) && $blue ne $ours, "$place: a copy draws its own" );
    rename "it's a copy", 'moved';
    ok( drawn("moved/$place/$name") eq $blue, "$place: and when it was moved" );
    remove_tree('moved');
}

plant( 'tree', 'build' );
symlink "$work/tree/build/$name", 'linked';
ok( drawn('./linked') eq $blue, 'a link to a program is that program' );
{
    local $ENV{PATH} = "$work/tree/build:$ENV{PATH}";
    ok( drawn($name) eq $blue, 'so is a name that is looked for' );
}

# A copy within another tree does not fall back to that.
plant( 'tree/mine', 'build' );
remove_tree( "tree/mine/$name/shaders", "tree/mine/$name/base" );
stops { command( "tree/mine/build/$name", @small, 'a.png' ) } 1,
  [qr{missing shader file $work/tree/mine/$name/shaders/}],
  'no shaders in a copy: its own are missed';

# Unreadable ones neither.
symlink 'nothing', "tree/mine/$name/shaders";
make_path("mine/$name/shaders");
symlink 'nothing', "mine/$name/shaders/scene.frag";
stops {
    command( "tree/build/$name", @small, 'a.png', qw(--shaders mine) )
}
1, [qr{missing shader file mine/$name/shaders/scene.frag}],
  'a link to nothing in --shaders is missed';

mkdir 'bin';
command( 'cp', program(1), 'bin' );
stops { command( "bin/$name", @small, 'a.png' ) } 1, [qr/no shaders.*--shaders/],
  'a program alone: one line';
my $run = command( "bin/$name", @small, 'a.png', qw(--shaders tree) );
is( $run->{status}, 0, 'and with --shaders it needs no more' )
  or diag( $run->{err} );

done_testing;
