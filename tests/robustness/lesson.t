# Every file of a lesson takes part in its picture, and no other file does: each
# shader, broken, changes what is drawn. And a lesson is short.
use strict;
use warnings;

use Draw;
use File::Temp qw(tempdir);
use Lists;
use Plant qw(planted);
use Test::More;
use VSM;

my @steps  = 1 .. 5;
my %lesson = map { $_ => [ made_list( program_name($_) . '_lesson' ) ] } @steps;
my $SHADER = qr/\.(?:glsl|vert|geom|frag|comp)\z/;
my %text;    # of every shader in the tree
for my $name ( map { program_name($_) } @steps ) {
    my @shaders = grep { /$SHADER/ } everything_below( root() . "/$name" );
    $text{"$name/$_"} = slurp( root() . "/$name/$_" ) for @shaders;
}

# An edit of each that compiles and changes a value: what stands there, the
# mistake, and the options under which its own step shows it, if not the
# default ones. Step 3 compares with M1 and does not look at M2, which step 5
# does.
my @edits = (
    [ 1, 'map.vert', '2.0 * map_position.xyz', '1.9 * map_position.xyz' ],
    [ 1, 'depth.frag', '= map_depth', '= 0.9 * map_depth' ],
    [ 1, 'scene.vert', '= object_albedo', '= 0.5 * object_albedo' ],
    [ 1, 'scene.frag', 'max(facing, 0.0)', '0.5 * facing' ],
    [ 1, 'light_depth.glsl', 'return clamp', 'return 0.9 * clamp' ],
    [ 1, 'linear_depth.glsl', 'return dot', 'return 0.5 + dot' ],
    [
        1, 'map_coordinates.glsl', 'map_position.xy /',
        '0.9 * map_position.xy /'
    ],
    [ 1, 'depth_slope.glsl', '/ facing', '* 100.0 / facing' ],
    [ 1, 'bias.glsl', 'return bias +', 'return 0.1 + bias +' ],
    [ 1, 'hard.glsl', '? 1.0 : 0.0', '? 0.0 : 1.0' ],
    [ 2, 'map_depth.glsl', '0.0).r', '0.0).r - 0.1' ],
    [ 2, 'pcf.glsl', 'lit / float', '0.5 * lit / float' ],
    [ 3, 'moments.frag', 'vec2(depth,', 'vec2(0.9 * depth,' ],
    [
        3, 'moments.frag', 'depth * depth',
        '0.9 * depth * depth', qw(--show variance)
    ],
    [ 3, 'lookup_bilinear.glsl', '0.0).rg', '0.0).rg * 0.9' ],
    [ 3, 'mean.glsl', '? 1.0 : 0.0', '? 0.0 : 1.0' ],
    [ 3, 'show_mean.glsl', '.x)', '.y)', qw(--show mean) ],
    [
        3, 'show_variance.glsl', 'decades + 9.0',
        'decades + 8.0', qw(--show variance)
    ],
    [ 3, 'scale_fire.glsl', '0.85', '0.5', qw(--show variance) ],
    [ 4, 'map_texel.glsl', '0.0).rg', '0.0).rg * 0.9' ],
    [
        4, 'downsample.frag', 'sum / float',
        '0.9 * sum / float', qw(--downsample 2)
    ],
    [ 4, 'blur.frag', 'moments += weights', 'moments += 0.9 * weights' ],
    [ 5, 'chebyshev.glsl', '(variance + behind', '(variance + 2.0 * behind' ],
    [
        5, 'reduction_linear.glsl', '- bleed_reduction',
        '- 0.5 * bleed_reduction', qw(--bleed-reduction 0.3)
    ],
    [ 5, 'visibility.glsl', 'max(M2', 'max(2.0 * M2' ],
);
$_->[1] = program_name( $_->[0] ) . "/shaders/$_->[1]" for @edits;
my %edited = map { $_->[1] => 1 } @edits;

# The picture with other texts in place of some files'. "" if it fails.
sub draw_with {
    my ( $texts, $step, @words ) = @_;
    my $shaders = File::Temp->newdir;
    spew( "$shaders/$_", $texts->{$_} ) for keys %$texts;
    return draw( $step, qw(--map-size 128 --shaders), "$shaders", @words );
}

my %plain;    # by step and options

sub plain {
    my ( $step, @words ) = @_;
    return $plain{"@_"} //= draw( $step, qw(--map-size 128), @words );
}

for my $step (@steps) {
    my $name  = program_name($step);
    my @mine  = @{ $lesson{$step} };
    my %mine  = map { $_ => 1 } @mine;
    my @there = map { s{.*/(?=$name/)}{}r }
      map { matching( root(), "$name/$_" ) } '*.[ch]', 'shaders/*';
    my @other = grep { !$mine{$_} } @there;
    is( "@other", '', "step $step: its top and shaders/ are its lesson" );
    my @missing = grep { /$SHADER/ && !$edited{$_} } @mine;
    is( "@missing", '', "step $step: an edit of each shader" );

    my ( $lines, $main ) = ( 0, slurp( root() . "/$name/main.c" ) =~ tr/\n// );
    $lines += slurp( root() . "/$_" ) =~ tr/\n// for @mine;
    my $most = ( 400, 200, 220, 350, 300 )[ $step - 1 ];
    cmp_ok( $lines, '<=', $most, "step $step: lines of its lesson" );
    cmp_ok( $main, '<=', 100, "step $step: lines of main.c" );
}

my @unseen;    # in step 5's picture
for (@edits) {
    my ( $step, $file, $from, $to, @words ) = @$_;
    my $broken  = { $file => planted( $file, $text{$file}, $from, $to ) };
    my $picture = draw_with( $broken, $step, @words );
    ok( $picture && $picture ne plain( $step, @words ),
        "step $step @words: $file is seen" );
    push @unseen, $file
      if $step < 5 && draw_with( $broken, 5 ) eq plain(5);
}

# What no program of these files compiles may hold anything.
sub is_not_compiled {
    my ( $step, $what, @files ) = @_;
    my %broken = map { $_ => "#error\n" } @files;
    ok( draw_with( \%broken, $step ) eq plain($step),
        "step $step: compiles none of $what" );
    return;
}

is_not_compiled( 5, 'those whose mistakes it does not show', @unseen );
cmp_ok( @unseen, '<', @edits / 2, 'step 5: shows those of most files' );
my %known = map { $_ => 1 } made_list('base'), map { @$_ } values %lesson;
my @others = grep { !$known{$_} } keys %text;
is_not_compiled( $_, "the techniques' files", @others ) for @steps;

done_testing;
