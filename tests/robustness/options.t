# Every option that steps 1 and 2 have, in every program that has it; those of
# the later steps are in options_moments.t and options_chebyshev.t.
use strict;
use warnings;

use File::Path qw(remove_tree);
use File::Temp qw(tempdir);
use JSON::PP   qw(decode_json);
use Draw;
use Options;
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

my @NO_NUMBER  = ( '', 'abc', '1x', 'nan', 'inf', '1e999' );
my @NO_SIZE    = qw(0 -1 1x x1 1x1x1 abc 99999999999 1e3 65536x1 16x0);
my @BASE_FILES = qw(image.exr normal.exr position.exr receiver.exr run.json
  visibility.exr);
my %DUMP_FILES = (
    1 => ['depth.0.exr'],
    2 => ['depth.0.exr'],
    3 => ['moments.0.exr'],
    4 => [ 'blurred.0.exr', 'moments.0.exr' ],
    5 => [ 'blurred.0.exr', 'moments.0.exr' ],
);

my %OPTIONS = (
    scene => {
        steps   => [ 1 .. 5 ],
        differ  => ['edge'],
        same    => ['teapot'],
        bad     => [ 'nope', '' ],           # the rest is in all_scenes.t
        allowed => qr/--list-scenes|NAME/,
    },
    light => {
        steps   => [ 1 .. 5 ],
        differ  => [ 'spot', 'point' ],
        same    => ['directional'],
        bad     => [ 'area', '', 'spot,point', 'Spot' ],
        allowed => qr/directional,\s?spot,\s?point/,
    },
    splits => {
        steps   => [ 1 .. 5 ],
        differ  => [ 2, 8 ],
        same    => [1],
        check   => \&check_splits,
        bad     => [ 0, 9, '', '2.0', '-1' ],
        allowed => qr/numbers from 1 to 8/,
    },
    shadows => {
        steps   => [ 1 .. 5 ],
        differ  => ['off'],
        same    => ['on'],
        check   => \&check_shadows,
        bad     => [ 'yes', '', 'on,off' ],
        allowed => qr/on,\s?off/,
    },
    'list-scenes'  => { steps => [ 1 .. 5 ] },    # in all_scenes.t
    'print-shader' => { steps => [ 1 .. 5 ] },    # in printed.t
    window         => { steps => [ 1 .. 5 ] },    # in window.t
    size           => {
        steps   => [ 1 .. 5 ],
        check   => \&check_size,
        bad     => [ @NO_SIZE, '', '16', ' 16x9' ],
        allowed => qr/WxH.*\b1 to \d+/,
    },
    'map-size' => {
        steps   => [ 1 .. 5 ],
        differ  => [ '64', '64x128' ],
        same    => ['512x512'],
        bad     => [ 0, '1x', '65536', '' ],
        allowed => qr/N or WxH.*\b1 to \d+/,
    },
    output => {
        steps   => [ 1 .. 5 ],
        check   => \&check_output,
        bad     => [ 'a.jpg', 'png', '.png', 'a.exr.', '' ],
        allowed => qr/\.png.*\.exr|FILE/,
    },
    show => {
        steps   => [ 1 .. 5 ],
        differ  => [ 'visibility', 'depth', 'layer', 'plan' ],
        same    => ['shaded'],
        check   => \&check_show,
        bad     => [ 'all', '', 'shade', 'shaded,visibility' ],
        allowed => qr/shaded,\s?visibility/,
    },
    dump => {
        steps   => [ 1 .. 5 ],
        check   => \&check_dump,
        bad     => [''],
        allowed => qr/DIR/,
    },
    shaders => {
        steps   => [ 1 .. 5 ],
        check   => \&check_shaders,
        bad     => [''],
        allowed => qr/DIR/,
    },
    context => {
        steps   => [ 1 .. 5 ],
        same    => ['osmesa'],
        bad     => [ 'glfw', '' ],
        allowed => qr/osmesa/,
    },
    bench => {
        steps   => [ 1 .. 5 ],
        check   => \&check_bench,
        bad     => [ -1, '', '1.5', 'x', 1000000 ],
        allowed => qr/numbers from \d to \d+/,
    },
    plan       => { steps => [ 1 .. 5 ], check => \&check_plan },
    'keep-all' => { steps => [ 1 .. 5 ], check => \&check_keep_all },
    move => {
        steps   => [ 1 .. 5 ],
        check   => \&check_move,
        bad     => [ 'teapot', '' ],    # without --bench
        allowed => qr/--bench|NAME/,
    },
    redraw     => { steps => [ 1 .. 5 ], check => \&check_redraw },
    bias       => {
        steps   => [ 1 .. 4 ],
        differ  => [ '0.05', '-1' ],
        same    => ['5e-4'],
        bad     => [ '1.1', '-1.1', @NO_NUMBER ],
        allowed => qr/numbers from -1 to 1/,
    },
    'slope-bias' => {
        steps   => [ 1 .. 4 ],
        differ  => [ '20',  '-1' ],
        bad     => [ '101', 'nan' ],
        allowed => qr/numbers from -100 to 100/,
    },
    kernel => {
        steps   => [2],
        differ  => [ 1, 9 ],
        same    => [7],
        bad     => [ 0, 2, 257, '', '3.0', 'abc' ],
        allowed => qr/odd numbers from 1 to 255/,
    },
    bilinear => { steps => [2], check => \&check_bilinear },
    pattern  => {
        steps   => [2],
        differ  => ['poisson'],
        same    => ['grid'],
        bad     => [ 'disc', '', 'grid,poisson' ],
        allowed => qr/grid,\s?poisson/,
    },
    adaptive => { steps => [2], check => \&check_adaptive },
);

sub check_size {
    my ($step) = @_;
    for my $words ( [qw(--size 9x16)], $step == 1 ? ['--size=1x1'] : () ) {
        my ($size) = "@$words" =~ /(\w+x\w+)/;
        is( png_size( draw( $step, @$words ) ),
            $size, "step $step: @$words sets the picture's size" );
    }
    return;
}

# The ending decides what is written (draw() writes .png). A file that is
# there is replaced.
sub check_output {
    my ($step) = @_;
    spew( 'old.exr', 'something else' );
    run( $step, qw(--size 16x9 --output old.exr) );
    is( substr( slurp('old.exr'), 0, 4 ),
        "\x76\x2f\x31\x01", "step $step: --output old.exr writes OpenEXR" );
    unlink 'old.exr';
    is_deeply( [ everything_below('.') ],
        [], "step $step: --output writes nothing else" );
    is_refused(
        $step, [qw(--output a.jpg)],
        [ qr/--output/, qr/\.png.*\.exr/ ],
        '--output a.jpg'
    );
    return;
}

# Moments can be shown from step 3 on, where there are some.
sub check_show {
    my ( $step, $plain ) = @_;
    for my $what ( $step == 3 ? ( 'mean', 'variance' ) : 'variance' ) {
        if ( $step < 3 ) {
            is_refused(
                $step,
                [ '--show', $what ],
                [qr/--show.*shaded.*depth/],
                "--show $what"
            );
            next;
        }
        my $picture = draw( $step, '--show', $what );
        ok( $picture && $picture ne $plain,
            "step $step: --show $what changes the picture" );
    }
    return;
}

# N frames give the medians of as many, as CSV, and the same picture.
sub check_bench {
    my ( $step, $plain ) = @_;
    my $run = run( $step, qw(--size 160x90 --bench 2 --output timed.png) );
    my ( $head, @lines ) = split /\n/, $run->{out};
    like( $head // '', qr/^pass,median_ms,/, "step $step: --bench has a head" );
    my @broken = grep { !/^\w+,[\d.]+,[\d.]+,[\d.]+,2,/ } @lines;
    ok( @lines >= 2 && !@broken, "step $step: --bench 2 times 2 frames" )
      or diag( $run->{out}, $run->{err} );
    ok(
        -e 'timed.png' && slurp('timed.png') eq $plain,
        "step $step: --bench draws the same picture"
    );
    unlink 'timed.png';
    return;
}

# The table has a row for each pass and each layer, and says why.
sub check_plan {
    my ( $step, $plain ) = @_;
    my @small   = qw(--size 160x90 --output planned.png --plan);
    my $run     = run( $step, @small );
    my ($table) = $run->{out} =~ /^(pass +decision .*?\nall .*)$/ms;
    my $pass    = $step < 3 ? 'depth' : 'moments';
    like(
        $table // '',
        qr/^lookup +kept .*\n$pass, layer 0 +kept +\d+ +\d+ +\w/m,
        "step $step: --plan prints what is kept"
    );
    ok(
        -e 'planned.png' && slurp('planned.png') eq $plain,
        "step $step: --plan draws the same picture"
    );
    $run = run( $step, @small, qw(--scene offstage) );
    like(
        $run->{out},
        qr/^lookup +left out .*\n$pass, layer 0 +left out +262144 +\d+ +\w/m,
        "step $step: --plan prints what is left out"
    );
    unlink 'planned.png';
    return;
}

sub check_keep_all {
    my ( $step, $plain ) = @_;
    is( draw( $step, '--keep-all' ),
        $plain, "step $step: --keep-all draws the same picture" );
    my $run = run(
        $step,
        qw(--size 160x90 --output kept.png --plan),
        qw(--scene offstage --keep-all)
    );
    like(
        $run->{out},
        qr/^lookup +kept .*--keep-all\n.*layer 0 +kept +0 /m,
        "step $step: --keep-all keeps all"
    );
    unlink 'kept.png';
    return;
}

# The median time of the pass that draws the map, or nothing.
sub map_time {
    my ( $step, @options ) = @_;
    my $run =
      run( $step, qw(--size 160x90 --bench 3 --output timed.png), @options );
    unlink 'timed.png';
    my ($time) = $run->{out} =~ /^(?:depth|moments),([\d.]+),/m;
    return $time;
}

sub check_move {
    my ( $step, $plain ) = @_;
    my @bench = qw(--bench 1 --move);
    my $moved = draw( $step, @bench, 'teapot' );
    ok( $moved && $moved ne $plain, "step $step: --move moves an object" );
    is_refused( $step, [ @bench, 'kettle' ],
        [qr/--move 'kettle'.*scene teapot.*one is 'rail'/],
        '--move what is not there' );
    return;
}

# A map that is drawn takes milliseconds, one that is not microseconds.
sub check_redraw {
    my ( $step, $plain ) = @_;
    is( draw( $step, '--redraw' ),
        $plain, "step $step: --redraw draws the same picture" );
    my ( $once, $always, $kept ) =
      map { map_time( $step, @$_ ) } [], ['--redraw'], ['--keep-all'];
    cmp_ok( 5 * $once, '<', $always, "step $step: the map is drawn once" );
    cmp_ok( 5 * $once, '<', $kept,   "step $step: but for --keep-all" );
    is( map_time( $step, qw(--scene offstage --redraw) ),
        undef, "step $step: no map where nothing looks it up" );
    return;
}

# Only a parallel light has splits.
sub check_splits {
    my ($step) = @_;
    for my $words ( [qw(--light point)], [qw(--scene stage)] ) {
        is_refused(
            $step,
            [ '--splits',     2, @$words ],
            [ qr/--splits 2/, qr/drop --splits/ ],
            "--splits 2 @$words"
        );
    }
    return;
}

# A map that is not there cannot be shown.
sub check_shadows {
    my ($step) = @_;
    return if $step < 3;
    is_refused(
        $step,
        [qw(--shadows off --show mean)],
        [qr/--show mean.*--shadows off.*drop one/],
        '--show mean without a map'
    );
    return;
}

sub check_bilinear {
    my ( $step, $plain ) = @_;
    my $picture = draw( $step, '--bilinear' );
    ok( $picture && $picture ne $plain,
        "step $step: --bilinear changes the picture" );
    is_refused(
        $step,
        [qw(--bilinear --pattern poisson)],
        [qr/--bilinear.*--pattern poisson.*drop one/],
        'two patterns'
    );
    return;
}

# Texels are wider than pixels by default, so that every filter is narrow; each
# pixel of a finer map has a width of its own.
sub check_adaptive {
    my ( $step, $plain ) = @_;
    my @fine = qw(--map-size 1024 --kernel 15);
    my ( $wide, $adaptive ) =
      map { draw( $step, @fine, @$_ ) } [], ['--adaptive'];
    ok( $adaptive && $adaptive ne $wide,
        "step $step: --adaptive changes the picture" );
    return;
}

# The name has what JSON has to escape.
sub check_dump {
    my ($step) = @_;
    my $folder = 'a "dump" \here';
    my $run    = run( $step, qw(--size 16x9 --output p.exr --dump), $folder );
    is_deeply(
        [ -d $folder ? everything_below($folder) : () ],
        [ sort @BASE_FILES, @{ $DUMP_FILES{$step} } ],
        "step $step: --dump writes every map, and nothing else"
    ) or diag( $run->{err} );
    my $json = eval { decode_json( slurp("$folder/run.json") ) } // {};
    is( $json->{options}{dump}, $folder, "step $step: run.json is JSON" )
      or diag($@);
    my @missing =
      grep { !exists $json->{options}{$_} } options_in_help($step);
    is( "@missing", '', "step $step: run.json has every option" );
    unlink 'p.exr';
    remove_tree($folder);
    return;
}

# A shader that was edited is used, and the others still come from the tree.
sub check_shaders {
    my ( $step, $plain ) = @_;
    my $shader = 'step1_shadowmap/shaders/scene.frag';
    my $text   = slurp( root() . "/$shader" );
    $text =~ s/= albedo \*/= albedo.bgr */ or die "$shader has changed\n";
    spew( "mine/$shader", $text );
    my $mine = draw( $step, qw(--shaders mine) );
    ok( $mine && $mine ne $plain, "step $step: --shaders takes my shader" );
    remove_tree('mine');
    return;
}

test_options( \%OPTIONS, 1, 2 );
done_testing;
