# What plain `make` leaves in out/, and says: with programs of ours, which
# draw one colour each and take no time.
use strict;
use warnings;

use Cwd        qw(abs_path);
use File::Path qw(make_path);
use File::Temp qw(tempdir);
use Test::More;
use VSM;

my $work = tempdir( CLEANUP => 1 );
chdir $work or die "cannot work in a temporary folder\n";

# The tree, whose folders hold shaders of their own here.
my @programs = map { program_name($_) } 1 .. 5;
symlink root() . "/$_", $_ for qw(Makefile tests);
for my $name (@programs) {
    make_path("$name/shaders");
    symlink root() . "/$name/$_", "$name/$_" for qw(Makefile base main.c);
}
spew( 'step2_pcf/shaders/a.glsl',       '' );
spew( 'build/glad/include/glad/gl.h', '' );

sub picture {
    my ( $file, $shade, $size ) = @_;
    command( qw(/usr/bin/env oiiotool --pattern), "constant:color=$shade",
        $size, qw(3 -d uint8 -o), $file );
    return $file;
}
my @colours = ( '1,0,0', '0,1,0', '0,0,1', '1,1,0', '0.4,0.6,0.8' );
my @halves;
for my $step ( 1 .. 5 ) {
    my $colour = $colours[ $step - 1 ];
    picture( "$step.png", $colour, '64x36' );
    push @halves, picture( "half$step.png", $colour, '32x18' );
    my $program = "build/$programs[$step - 1]";
    spew( $program, <<"SH");
#!/bin/sh
case \$* in
*--bench*) [ ! -e fails ] || { echo no time >&2; exit 1; }
    printf 'pass,median_ms\\nshading,1\\ntotal,3\\n' ;;
--output*) cp $step.png "\$2" ;;
esac
SH
    chmod 0755, $program;
}

delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES STEP DEPS BUILD)};
delete @ENV{qw(CFLAGS CXXFLAGS LDFLAGS)};

# What our programs are made from is not looked at.
sub make {
    return command( qw(/usr/bin/env make DEPS=no BUILD=build),
        map { ( '-o', "build/$_" ) } @programs );
}
my $where = qr{^look at out/steps\.png, and at out/step1\.png to .*\n\z}m;
command( qw(/usr/bin/env oiiotool),
    @halves, qw(--mosaic:pad=8 5x1 -d uint8 -o expected.png) );

sub is_right {
    my ( $run, $name ) = @_;
    is( $run->{status} . $run->{err}, '0', $name );
    like( $run->{out}, $where, "$name: where the pictures are" );
    my @wrong = grep { slurp("out/step$_.png") ne slurp("$_.png") } 1 .. 5;
    is( "@wrong", '', "$name: the pictures" );
    my $same = command( qw(/usr/bin/env idiff expected.png out/steps.png) );
    is( $same->{status}, 0, "$name: side by side" ) or diag( $same->{out} );
    return;
}

spew( 'fails', '' );
my $run = make();
is( $run->{status}, 2, 'a table that fails' );
like( $run->{err}, qr/^no time$/m, 'says why' );
ok( -s 'out/steps.png', 'and leaves the pictures' );
unlink 'fails';
$run = make();
is_right( $run, 'then' );
like( $run->{out}, qr/^step5_chebyshev +2\.0 +1\.0 +3\.0$/m, 'and the table' );
unlike( $run->{out}, qr/--output/, 'and draws nothing' );

$run = make();
is_right( $run, 'again' );
is( ( $run->{out} =~ tr/\n// ), 1, 'again: one line' );

# Somebody draws something else, loses a picture, edits a shader.
command( '/bin/cp', '1.png', 'out/step5.png' );
is_right( make(), 'after a drawing by hand' );
unlink 'out/step2.png';
is_right( make(), 'without a picture' );
unlink 'out/steps.png';
command( '/bin/cp', '1.png', 'out/step4.png' );
is_right( make(), 'without the strip' );
utime undef, undef, 'step2_pcf/shaders/a.glsl';
$run = make();
is_right( $run, 'after an edit' );
like( $run->{out}, qr/ --output out\/step1\.png$/m, 'which draws' );

# The strip by itself.
stops { command( qw(build/strip x.png 1.png half2.png) ) } 1,
  [qr/half2\.png: .*size/], 'another size';
stops { command( qw(build/strip x.png 1.png fails.png) ) } 1,
  [qr/fails\.png: /], 'no picture';
stops { command( qw(build/strip /nowhere/x.png 1.png) ) } 1,
  [qr{/nowhere/x\.png: }], 'no place';

chdir '/';
done_testing;
