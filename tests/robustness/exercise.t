# `make exercise` and `make grade`: every mistake that the marks know is told
# from the others, by what it draws.
use strict;
use warnings;

use File::Temp qw(tempdir);
use FindBin;
use lib "$FindBin::Bin/../exercise";
use Test::More;
use Marks;
use Tasks;
use VSM;

my $work = tempdir( CLEANUP => 1 );

# What `make test` hands down to a make below it.
delete @ENV{qw(MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES STEP DIR)};
@Marks::SIZE = qw(--size 96x54 --map-size 128);

sub script {
    my ( $name, @words ) = @_;
    return command( $^X, root() . "/tests/exercise/$name.pl", @words );
}

# The right text with a statement in front.
sub begun_with {
    my ( $step, $task, $statement ) = @_;
    my $text    = slurp( root() . '/' . task_file( $step, $task ) );
    my $heading = join '\s+', map { quotemeta } split ' ', $task->{function};
    $text =~ s/^($heading\n\{)/$1 $statement/m or die "no $heading\n";
    return $text;
}

for my $step ( 1 .. 5 ) {
    for my $task ( tasks($step) ) {
        my $what  = "step $step, $task->{file}";
        my $right = slurp( root() . '/' . task_file( $step, $task ) );
        my @wrong = mark( $step, $task, $right );
        is( "@wrong", '', "$what is right" );
        my ($reason) = mark( $step, $task, emptied( $step, $task ) );
        is( $reason, 'It is not written yet.', "$what, emptied" );
        for my $mistake ( @{ $task->{mistakes} } ) {
            my ($words) = @$mistake;
            my $text = mistaken( $step, $task, $mistake );
            ($reason) = mark( $step, $task, $text );
            is( $reason, $words, "$what: $words" );
        }
        for my $also ( @{ $task->{also} } ) {
            my %run = ( %$task, mistakes => undef, also => [], %$also );
            @wrong = mark( $step, \%run, emptied( $step, $task ) );
            isnt( "@wrong", '', "$what is used with @{ $run{options} }" );
        }
        @wrong = mark( $step, $task, begun_with( $step, $task, 'discard;' ) );
        isnt( "@wrong", '', "$what, which draws nothing" );
    }
}

# What the first run lets a function hold fixed, and another one does not: what
# is instead of what.
my $SIZE = 'textureSize(shadow_map, 0).xy';
for (
    [ 1, 'hard.glsl', $SIZE => 'ivec2(128)' ],
    [ 1, 'hard.glsl', 'receiver.layer)' => '0)' ],
    [ 1, 'map_coordinates.glsl', 'relative[layer]' => 'relative[0]' ],
    [ 1, 'map_coordinates.glsl', 'position, layer)' => 'position, 0)' ],
    [ 1, 'map_coordinates.glsl', 'return all(' => 'return true || all(' ],
    [
        2, 'pcf.glsl',
        'kernel,'         => '7,',
        'kernel /'        => '7 /',
        'kernel * kernel' => '49'
    ],
    [ 2, 'pcf.glsl', 'receiver.layer)' => '0)' ],
    [ 2, 'pcf.glsl', $SIZE => 'ivec2(128)' ],
    [ 3, 'moments.frag', 'position, layer' => 'position, 0' ],
    [ 3, 'moments.frag', 'map_depth(' => 'light_depth(' ],
    [ 3, 'mean.glsl', "vec2($SIZE)" => 'vec2(128.0)' ],
    [
        4, 'downsample.frag',
        '* factor'   => '* 2',
        'y < factor' => 'y < 2',
        'x < factor' => 'x < 2'
    ],
    [ 4, 'downsample.frag', 'float(factor * factor)' => '4.0' ],
    [
        4, 'blur.frag',
        '-radius'   => '-4',
        '<= radius' => '<= 4',
        '+ radius'  => '+ 4'
    ],
    [
        5, 'reduction_linear.glsl',
        '(p_max - bleed_reduction) / (1.0 - bleed_reduction)' =>
          '(p_max - 0.3) / 0.7'
    ],
    [
        5, 'visibility.glsl',
        'reduce_bleeding(chebyshev(mean, variance, receiver.depth))' =>
          'clamp((chebyshev(mean, variance, receiver.depth) - 0.18) '
          . '/ 0.82, 0.0, 1.0)'
    ],
    [ 5, 'visibility.glsl', 'min_variance)' => '0.0)' ],
  )
{
    my ( $step, $file, @pairs ) = @$_;
    my ($task) = grep { $_->{file} eq $file } tasks($step);
    my ($words) =
      mark( $step, $task, mistaken( $step, $task, [ '', @pairs ] ) );
    like( $words // 'right', qr/^It is right with .*, and wrong with/,
        "step $step, $file with '$pairs[1]'" );
}

# As good, but written otherwise; wrong in a way that nobody knows; no number.
my ($chebyshev) = grep { $_->{file} eq 'chebyshev.glsl' } tasks(5);

sub chebyshev_mark {
    my ($body) = @_;
    return mark( 5, $chebyshev, "$chebyshev->{function}\n{\n$body\n}\n" );
}
is( join( "\n", chebyshev_mark(<<'END') ), '', 'another way to say it' );
    float s = max(t - mean, 0.0);
    return 1.0 - s * s / (variance + s * s);
END

my ($visibility) = grep { $_->{file} eq 'visibility.glsl' } tasks(5);
my @said = mark( 5, $visibility, <<"END" );
$visibility->{function}
{
    vec2 m = moments_at(receiver);
    float guard = dot(guard_variance, vec2(m.y, 1.0));
    float root = sqrt(m.y);
    float variance = (root - m.x) * (root + m.x) + guard;
    float mean = m.x * (1.0 + guard_mean.x) + guard_mean.y;
    return reduce_bleeding(chebyshev(
        mean, max(variance, min_variance + guard), receiver.depth));
}
END
is( "@said", '', 'and the variance' );
@said = mark( 5, $visibility,
    mistaken( 5, $visibility, [ '', 'max(M2 - M1 * M1' => 'max(M2 - M1' ] ) );
like( $said[0], qr/^The variance is 0,/, 'no variance' );

# As right where something is drawn; but other pixels, or other surfaces, are.
for my $statement (
    'if (int(gl_FragCoord.x) % 2 == 0) { discard; }',
    'gl_FragDepth = 1.0 - gl_FragCoord.z;'
  )
{
    my ($said) =
      mark( 5, $chebyshev, begun_with( 5, $chebyshev, $statement ) );
    like( $said, qr/same pixels.*discard/, "chebyshev() with $statement" );
}
like( ( chebyshev_mark('return 0.5;') )[0],
    qr/none of the mistakes/, 'unknown' );
my ($hard) = grep { $_->{file} eq 'hard.glsl' } tasks(1);
@said = mark( 1, $hard,
    "$hard->{function} { return sqrt(-1.0 - receiver.depth); }",
    sub { join ' ', png_size( $_[0] ), $_[1] } );
like( $said[0], qr/no numbers/, 'not a number' );
like( $said[-1], qr/^296x54 yours.*\(blue\)$/, 'is shown' );
{
    local $VSM::SECONDS = 1;
    my $turn = 'p = sin(p + variance); ' x 100;
    my ($said) = chebyshev_mark(<<"END");
    float p = 0.0;
    for (int i = 0; i < 60000; i++) {
        $turn
    }
    return p;
END
    like( $said, qr/^It took longer than 1 s: does a loop/, 'does not end' );
}
like(
    join( ' ', chebyshev_mark('return variance') ),
    qr{shader step5_chebyshev/shaders/chebyshev\.glsl:\d.*syntax error}s,
    'what does not compile is told with file and line'
);

# The commands: a copy is made, refused where one is, and marked.
my $mine = "$work/mine";
my $run  = script( 'exercise', 1, $mine );
is( $run->{status}, 0, 'exercise' ) or diag( $run->{err} );
my @files = map { task_file( 1, $_ ) } tasks(1);
for my $file (@files) {
    like( $run->{out}, qr/\Q$mine\/$file\E/, "$file is named" );
    like( slurp("$mine/$file"), qr{// YOURS\. }, 'and empty' );
}
stops { script( 'exercise', 1, $mine ) } 2, [qr/\Q$mine\E is there already/],
  'nobody\'s work is written over';
spew( "$work/two\nlines/file", 'work' );
stops { script( 'exercise', 1, "$work/two\nlines" ) } 2, [qr/two\?lines is/],
  'nor under an odd name';
stops { script( 'exercise', 6, "$work/six" ) } 2, [qr/STEP=5/], 'no step 6';
stops { script( 'grade', 1, "$work/none" ) } 2, [qr/there is no .*exercise/],
  'nothing to mark';

spew( "$mine/$files[1]", slurp( root() . "/$files[1]" ) );
$run = script( 'grade', 1, $mine );
is( $run->{status}, 1, 'half of it is written: exit status' )
  or diag( $run->{err} );
like( $run->{out}, qr/^wrong  .*\n +It is not written yet/m, 'not written' );
like( $run->{out}, qr/^right  .*hard/m,            'written' );
like( $run->{out}, qr/^1 of 2 functions right$/m, 'and counted' );
unlike( $run->{out}, qr/not looked at/, 'the copy is as it was made' );
is( png_size( slurp("$mine/grade/map_coordinates.png") ),
    '968x180', 'yours, the right one, the difference' );

# Shaders are drawn with; nothing else that was changed is looked at.
my $main = 'step1_shadowmap/main.c';
spew( "$mine/$files[0]", slurp( root() . "/$files[0]" ) );
spew( "$mine/$main",     "no C\n" );
spew( "$mine/Makefile",
    "\$(shell touch $work/made)\nall:\n\ttouch made\n" );
$run = script( 'grade', 1, $mine );
is( $run->{status}, 0, 'all of it is written' )
  or diag( $run->{out}, $run->{err} );
like( $run->{out}, qr/^right  the whole program\n/m, 'and draws' );
like( $run->{out}, qr/^changed, not looked at: Makefile \Q$main\E$/m,
    'what is no shader is named' );
ok( !-e "$work/made" && !-e "$mine/made" && !-e "$mine/build",
    'and not built' );
ok( !-e "$mine/grade/map_coordinates.png", 'no picture is left of before' );

# Wrong only where a map has several layers.
my $face = 'step1_shadowmap/techniques/lights/layer_face.glsl';
spew( "$mine/$face", slurp("$mine/$face") =~ s/2 \* axis/axis/r );
$run = script( 'grade', 1, $mine );
is( $run->{status}, 1, 'what was changed besides is not right' );
like( $run->{out}, qr/with .*--scene room.*\n +changed: \Q$face\E$/m,
    'and is named' );

done_testing;
