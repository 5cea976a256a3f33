# Every option of every program: a good value works and does something, a bad
# value is refused in one line that says what is allowed, and then nothing is
# written. The options are read from --help, so that a new one without an
# entry in the table below fails here.
use strict;
use warnings;

use File::Path qw(remove_tree);
use File::Temp qw(tempdir);
use JSON::PP   qw(decode_json);
use Draw;
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

# steps:   which programs have the option
# differ:  values that draw another picture than the program's defaults do
# same:    values that draw the same picture
# bad:     values to refuse; `allowed` is in the line that refuses them
# check:   what else a good value has to do
# A run takes 0.2 s, most of it for loading libraries. So the lists are tried in
# full in the first program that has the option; the others, which share the
# code, try the first value of `differ`, or else of `bad`.
my %OPTIONS = (
    scene => {
        steps   => [ 1 .. 5 ],
        differ  => ['edge'],
        same    => ['teapot'],
        bad     => [ 'nope', '' ],    # the rest is in scenes.t
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
    'list-scenes' => { steps => [ 1 .. 5 ] },    # in scenes.t
    window        => { steps => [ 1 .. 5 ] },    # in window.t
    size          => {
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
    redraw     => { steps => [ 1 .. 5 ], check => \&check_redraw },
    bias => {
        steps   => [ 1 .. 4 ],
        differ  => [ '0.05', '-1' ],
        same    => ['5e-4'],
        bad     => [ '1.1', '-1.1', @NO_NUMBER ],
        allowed => qr/numbers from -1 to 1/,
    },
    'slope-bias' => {
        steps   => [ 1 .. 4 ],
        differ  => [ '20', '-1' ],
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
    format   => {
        steps   => [ 3 .. 5 ],
        same    => [qw(rg32f auto)],
        check   => \&check_format,
        bad     => [ 'rg8', '' ],
        allowed => qr/rg32f/,
    },
    depth => {
        steps   => [ 3 .. 5 ],
        same    => [qw(linear projected)],    # of a directional light
        check   => \&check_depth,
        bad     => [ 'linear,projected', '', 'z' ],
        allowed => qr/linear,\s?projected/,
    },
    moments => {
        steps   => [ 3 .. 5 ],
        check   => \&check_moments,
        bad     => [ 'both', '', 'raw,central' ],
        allowed => qr/raw,\s?central/,
    },
    'slope-term' => { steps => [ 3 .. 5 ], check => \&check_slope_term },
    'slope-from' => {
        steps   => [ 3 .. 5 ],
        bad     => [ 'both', '' ],
        allowed => qr/plane,\s?derivatives/,
    },
    msaa => {
        steps   => [ 3 .. 5 ],
        differ  => [4],
        same    => [1],
        check   => \&check_msaa,
        bad     => [ 0, 65, '', '4.0', 'x' ],
        allowed => qr/numbers from 1 to 64/,
    },
    blur => {
        steps   => [ 4, 5 ],
        differ  => [qw(none boxes gaussian binomial)],
        same    => ['box'],
        bad     => [ 'cube', '' ],
        allowed => qr/none,\s?box/,
    },
    'blur-by' => {
        steps   => [ 4, 5 ],
        check   => \&check_blur_by,
        bad     => [ 'gpu', '' ],
        allowed => qr/auto,compute,fragments/,
    },
    radius => {
        steps   => [ 4, 5 ],
        differ  => [ 9, 0 ],
        same    => [3],
        bad     => [ 256, -1, '', '1.5', '99999999999' ],
        allowed => qr/\b0 to \d+/,
    },
    downsample => {
        steps   => [ 4, 5 ],
        differ  => [ 2, 16 ],
        same    => [1],
        bad     => [ 3, 0, '', '2.0', 32 ],
        allowed => qr/\b1 to 16|does not divide --map-size/,
    },
    mips => {
        steps => [ 4, 5 ],
        check => sub {
            my ($step) = @_;
            check_flag( $step, 'mips' );
            is_refused( $step, [qw(--mips --map-size 255)],
                [ qr/--mips/, qr/--map-size/ ], '--mips of an odd map' );
        },
    },
    anisotropy => {
        steps   => [ 4, 5 ],
        check   => \&check_anisotropy,
        bad     => [ 0, 17, '', '2.0' ],
        allowed => qr/\b1 to 16/,
    },
    sat => {
        steps => [ 4, 5 ],
        check => \&check_sat,
    },
    sampler => {
        steps   => [ 4, 5 ],
        check   => \&check_sampler,
        bad     => [ 'gpu', '' ],
        allowed => qr/explicit,hardware/,
    },
    'sat-by' => {
        steps   => [ 4, 5 ],
        check   => \&check_sat_by,
        bad     => [ 'gpu', '' ],
        allowed => qr/auto,compute,fragments/,
    },
    deferred       => { steps => [5], check => \&check_deferred },
    'sat-width' => {
        steps   => [5],
        check   => \&check_sat_width,
        bad     => [ 'wide', '7', '' ],
        allowed => qr/fixed,adaptive/,
    },
    soft         => { steps => [5], check => \&check_soft },
    'light-size' => {
        steps   => [5],
        check   => \&check_soft_number,
        bad     => [ '-0.1', 'sun', '', '1e7', 'nan' ],
        allowed => qr/numbers from 0 to 1e\+06/,
    },
    'penumbra-scale' => {
        steps   => [5],
        check   => \&check_soft_number,
        bad     => [ '-1', '101', '', 'inf' ],
        allowed => qr/numbers from 0 to 100/,
    },
    hybrid         => { steps => [5], check => \&check_hybrid },
    'min-variance' => {
        steps   => [5],
        differ  => ['0.001'],
        same    => ['auto'],
        bad     => [ '-1', '1.1', 'automatic', 'nan', '' ],
        allowed => qr/numbers from 0 to 1, or auto/,
    },
    'variance-bias' => {
        steps   => [5],
        differ  => ['1e-3'],
        same    => [0],
        bad     => [ '-1e-3', '1.1', '' ],
        allowed => qr/numbers from 0 to 1/,
    },
    reduction => {
        steps   => [5],
        differ  => ['smooth'],
        same    => ['linear'],
        bad     => [ 'none', '' ],
        allowed => qr/linear,smooth/,
    },
    'bleed-reduction' => {
        steps   => [5],
        differ  => [ '0.6', 0 ],
        bad     => [ 1, '-0.1', '' ],
        allowed => qr/numbers from 0 to 0\.9999/,
    },
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
    is_refused( $step, [qw(--output a.jpg)],
        [ qr/--output/, qr/\.png.*\.exr/ ], '--output a.jpg' );
    return;
}

# Moments can be shown from step 3 on, where there are some.
sub check_show {
    my ( $step, $plain ) = @_;
    for my $what ( $step == 3 ? ( 'mean', 'variance' ) : 'variance' ) {
        if ( $step < 3 ) {
            is_refused( $step, [ '--show', $what ],
                [qr/--show.*shaded.*depth/], "--show $what" );
            next;
        }
        my $picture = draw( $step, '--show', $what );
        ok( $picture && $picture ne $plain,
            "step $step: --show $what changes the picture" );
    }
    return;
}

# Half precision shows; where a bias would hide it, without one.
sub check_format {
    my ($step) = @_;
    my @bare = $step < 5 ? ( '--bias', 0 ) : ();
    my ( $full, $half ) =
      map { draw( $step, @bare, '--format', $_ ) } 'rg32f', 'rg16f';
    ok( $full && $half && $full ne $half,
        "step $step: --format rg16f changes the picture" );
    return;
}

# A spot light tells the two depths apart.
sub check_depth {
    my ($step) = @_;
    my ( $linear, $projected ) =
      map { draw( $step, qw(--scene stage --show mean --depth), $_ ) }
      qw(linear projected);
    ok( $linear && $projected && $linear ne $projected,
        "step $step: --depth projected changes a spot light's picture" );
    return;
}

# The variance of a map that nothing has filtered.
sub check_slope_term {
    my ($step) = @_;
    my @words = ( qw(--show variance), $step > 3 ? qw(--radius 0) : () );
    my ( $off, $plane, $next ) = map { draw( $step, @words, @$_ ) } [],
      ['--slope-term'], [qw(--slope-term --slope-from derivatives)];
    ok( $off && $plane && $next && $off ne $plane && $off ne $next,
        "step $step: --slope-term changes the variance" );
    is_refused( $step, [qw(--slope-from plane)],
        [qr/--slope-from plane needs --slope-term: add.*or drop/],
        '--slope-from without --slope-term' );
    is_refused( $step, [qw(--slope-term --slope-from derivatives --msaa 4)],
        [qr/--slope-from derivatives.*--msaa 4.*drop one/],
        'derivatives with --msaa' );
    return;
}

# What the driver cannot make it says; --dump writes what is resolved.
# The default of each step; and in 16 bits raw moments have no variance left.
sub check_moments {
    my ( $step, $plain ) = @_;
    my $default = $step == 5 ? 'central' : 'raw';
    is( draw( $step, '--moments', $default ),
        $plain, "step $step: --moments $default changes nothing" );
    my ( $raw, $central ) =
      map { draw( $step, qw(--show variance --format rg16f --moments), $_ ) }
      qw(raw central);
    ok( $raw && $central && $raw ne $central,
        "step $step: --moments central keeps a variance that raw lost" );
    return;
}

sub check_msaa {
    my ($step) = @_;
    is_refused( $step, [qw(--msaa 64)],
        [qr/--msaa 64.*driver's limit of \d+ samples/],
        'more samples than the driver has' );
    is_refused( $step, [qw(--msaa 3)],
        [qr/--msaa 3: this driver makes (\d+) samples.*give \1, or drop --msaa/],
        'a number of samples that the driver does not have' );
    run( $step, qw(--size 16x9 --msaa 4 --output p.exr --dump d) );
    is_deeply(
        [ grep { /sample/ } -d 'd' ? everything_below('d') : () ],
        [ 'sample_positions.exr', map { "samples.0.$_.exr" } 0 .. 3 ],
        "step $step: --msaa 4 --dump writes the samples"
    );
    unlink 'p.exr';
    remove_tree('d');
    return;
}

# N frames give the medians of as many, as CSV, and the same picture.
sub check_bench {
    my ( $step, $plain ) = @_;
    my $run = run( $step,
        qw(--size 160x90 --bench 2 --output timed.png) );
    my ( $head, @lines ) = split /\n/, $run->{out};
    like( $head // '', qr/^pass,median_ms,/, "step $step: --bench has a head" );
    my @broken = grep { !/^\w+,[\d.]+,[\d.]+,[\d.]+,2,/ } @lines;
    ok( @lines >= 2 && !@broken, "step $step: --bench 2 times 2 frames" )
      or diag( $run->{out}, $run->{err} );
    ok( -e 'timed.png' && slurp('timed.png') eq $plain,
        "step $step: --bench draws the same picture" );
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
    like( $table // '',
        qr/^lookup +kept .*\n$pass, layer 0 +kept +\d+ +\d+ +\w/m,
        "step $step: --plan prints what is kept" );
    ok( -e 'planned.png' && slurp('planned.png') eq $plain,
        "step $step: --plan draws the same picture" );
    $run = run( $step, @small, qw(--scene offstage) );
    like( $run->{out},
        qr/^lookup +left out .*\n$pass, layer 0 +left out +262144 +\d+ +\w/m,
        "step $step: --plan prints what is left out" );
    unlink 'planned.png';
    return;
}

sub check_keep_all {
    my ( $step, $plain ) = @_;
    is( draw( $step, '--keep-all' ),
        $plain, "step $step: --keep-all draws the same picture" );
    my $run = run( $step, qw(--size 160x90 --output kept.png --plan),
        qw(--scene offstage --keep-all) );
    like( $run->{out}, qr/^lookup +kept .*--keep-all\n.*layer 0 +kept +0 /m,
        "step $step: --keep-all keeps all" );
    unlink 'kept.png';
    return;
}

# The median time of the pass that draws the map, or nothing.
sub map_time {
    my ( $step, @options ) = @_;
    my $run = run( $step,
        qw(--size 160x90 --bench 3 --output timed.png), @options );
    unlink 'timed.png';
    my ($time) = $run->{out} =~ /^(?:depth|moments),([\d.]+),/m;
    return $time;
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
        is_refused( $step, [ '--splits', 2, @$words ],
            [ qr/--splits 2/, qr/drop --splits/ ], "--splits 2 @$words" );
    }
    return;
}

# A map that is not there cannot be shown.
sub check_shadows {
    my ($step) = @_;
    return if $step < 3;
    is_refused( $step, [qw(--shadows off --show mean)],
        [qr/--show mean.*--shadows off.*drop one/],
        '--show mean without a map' );
    return;
}

sub check_bilinear {
    my ( $step, $plain ) = @_;
    my $picture = draw( $step, '--bilinear' );
    ok( $picture && $picture ne $plain,
        "step $step: --bilinear changes the picture" );
    is_refused( $step, [qw(--bilinear --pattern poisson)],
        [qr/--bilinear.*--pattern poisson.*drop one/], 'two patterns' );
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

# Maps with more texels than the small picture has pixels, else all pixels are
# at level 0. Step 4 shows the mean: its comparisons hide small differences.
my @FINE = qw(--show mean --map-size 1024 --radius 0);

sub check_flag {
    my ( $step, $name ) = @_;
    my ( $off, $on ) = map { draw( $step, @FINE, @$_ ) } [], ["--$name"];
    ok( $off && $on && $off ne $on, "step $step: --$name changes the picture" );
    return;
}

sub check_anisotropy {
    my ($step) = @_;
    my ( $one, $many ) =
      map { draw( $step, @FINE, '--mips', @$_ ) } [], [qw(--anisotropy 16)];
    ok( $one && $many && $one ne $many,
        "step $step: --anisotropy 16 changes the picture" );
    is_refused( $step, [qw(--anisotropy 4)],
        [qr/--anisotropy.*add --mips or drop/], '--anisotropy without --mips' );
    return;
}

# The same box as the blur's, from other sums.
sub check_sat {
    my ($step) = @_;
    my ( $blur, $table ) =
      map { draw( $step, qw(--show variance --size 320x180), @$_ ) } [],
      ['--sat'];
    ok( $blur && $table && $blur ne $table,
        "step $step: --sat changes the picture" );
    is_refused( $step, [qw(--sat --mips)], [qr/--sat.*--mips.*drop one/],
        '--sat with --mips' );
    for my $kernel (qw(none gaussian binomial)) {
        is_refused(
            $step,
            [ qw(--sat --blur), $kernel ],
            [qr/--sat.*--blur $kernel.*drop one/],
            "--sat with --blur $kernel"
        );
    }
    return;
}

# Mesa can be told to leave an extension out.
sub check_sampler {
    my ($step) = @_;
    my @words = ( @FINE, qw(--mips --anisotropy 8 --sampler) );
    my ( $explicit, $hardware ) = map { draw( $step, @words, $_ ) }
      qw(explicit hardware);
    ok( $explicit && $hardware && $explicit ne $hardware,
        "step $step: --sampler hardware changes the picture" );
    is_refused( $step, [qw(--sampler hardware)],
        [qr/--sampler hardware.*add --mips or drop --sampler/],
        '--sampler without --mips' );
    is_refused(
        $step,
        [ qw(--scene room --mips --anisotropy 8 --sampler), 'hardware' ],
        [qr/--sampler hardware.*--anisotropy.*one layer.*drop one/],
        'taps of the texture unit next to another layer'
    );
    local $ENV{MESA_EXTENSION_OVERRIDE} =
      '-GL_EXT_texture_filter_anisotropic';
    is_refused( $step, [ qw(--mips --anisotropy 8 --sampler), 'hardware' ],
        [qr/--sampler hardware.*--anisotropy.*drop one/],
        'what the driver cannot sample' );
    return;
}

# The same picture; where the driver has no compute shaders, the choice is made
# or refused. Mesa can be told to be an older driver.
sub check_sat_by {
    my ($step) = @_;
    my @words = qw(--sat --sat-by);
    my ( $auto, $compute, $fragments ) =
      map { draw( $step, @words, $_ ) } qw(auto compute fragments);
    ok( $auto && $auto eq $compute && $auto eq $fragments,
        "step $step: --sat-by does not change the picture" );
    is_planned( $step, 'summed-area table', @$_ )
      for [ 'compute', '--sat' ], [ 'fragments', @words, 'fragments' ];
    is_refused( $step, [qw(--sat-by compute)],
        [qr/--sat-by compute.*add --sat or drop --sat-by/],
        '--sat-by without --sat' );
    local $ENV{MESA_GL_VERSION_OVERRIDE} = '3.3';
    is_refused( $step, [ @words, 'compute' ],
        [qr/--sat-by compute.*4\.3.*drop --sat-by/],
        '--sat-by compute without OpenGL 4.3' );
    ok( draw( $step, '--sat' ) eq $auto,
        "step $step: --sat without OpenGL 4.3" );
    return;
}

# The same filter, rounded in another order; where the driver has no compute
# shaders, the choice is made or refused.
# Who does a pass, as --plan says.
sub is_planned {
    my ( $step, $pass, $by, @options ) = @_;
    my $run = run( $step, qw(--size 160x90 --output planned.png --plan),
        @options );
    like( $run->{out}, qr/^$pass .* by $by/m,
        "step $step @options: --plan says by $by" );
    unlink 'planned.png';
    return;
}

sub check_blur_by {
    my ($step) = @_;
    my @words = qw(--scene edge --show variance --moments raw --radius 8
      --blur boxes --blur-by);
    my ( $auto, $compute, $fragments ) =
      map { draw( $step, @words, $_ ) } qw(auto compute fragments);
    ok( $auto && $auto eq $compute, "step $step: --blur-by auto is compute" );
    ok( $fragments && $fragments ne $compute,
        "step $step: --blur-by fragments rounds otherwise" );
    is_planned( $step, 'blur along u', @$_, qw(--radius 8) )
      for [ 'running boxes', qw(--blur boxes) ],
      [ 'fragments', qw(--blur gaussian) ];
    for my $other ( [qw(--blur gaussian)], [qw(--format rg16f)] ) {
        is_refused(
            $step, [ @$other, qw(--blur-by compute) ],
            [qr/--blur-by compute.*@$other.*drop one/],
            "--blur-by compute with @$other"
        );
    }
    is_refused( $step, [qw(--sat --blur-by fragments)],
        [qr/--blur-by fragments.*--sat.*drop one/], '--blur-by with --sat' );
    local $ENV{MESA_GL_VERSION_OVERRIDE} = '3.3';
    is_refused( $step, [qw(--blur-by compute)],
        [qr/--blur-by compute.*4\.3.*drop --blur-by/],
        '--blur-by compute without OpenGL 4.3' );
    is( draw( $step, @words, 'auto' ),
        $fragments, "step $step: --blur-by auto without OpenGL 4.3" );
    return;
}

sub check_sat_width {
    my ($step) = @_;
    my @words = qw(--radius 9 --sat --sat-width);
    my ( $fixed, $adaptive ) = map { draw( $step, @words, $_ ) } qw(fixed adaptive);
    ok( $fixed && $adaptive && $fixed ne $adaptive,
        "step $step: --sat-width adaptive changes the picture" );
    is_refused( $step, [qw(--sat-width adaptive)],
        [qr/--sat-width.*add --sat or drop --sat-width/],
        '--sat-width without --sat' );
    return;
}

# The same picture, from a buffer; the background is none of it.
sub check_deferred {
    my ( $step, $plain ) = @_;
    is( draw( $step, '--deferred' ),
        $plain, "step $step: --deferred draws the same picture" );
    return;
}

# The mip-maps come by themselves; what would choose another lookup is refused.
sub check_soft {
    my ( $step, $plain ) = @_;
    my ( $soft, $mips, $blurred ) =
      map { draw( $step, '--soft', @$_ ) } [], ['--mips'], [qw(--radius 5)];
    ok( $soft && $soft ne $plain, "step $step: --soft changes the picture" );
    is( $mips, $soft, "step $step: --soft has mip-maps" );
    ok( $blurred && $blurred ne $soft,
        "step $step: --soft --radius 5 changes the picture" );
    for my $other (
        [qw(--sat)],
        [qw(--sampler hardware)],
        [qw(--anisotropy 4)],
        [qw(--mips --anisotropy 1)]
      )
    {
        my ($name) = grep { /^--[sa]/ } @$other;
        is_refused( $step, [ '--soft', @$other ],
            [ qr/--soft/, qr/$name/, qr/drop/ ], "--soft with @$other" );
    }
    is_refused( $step, [qw(--soft --map-size 255)],
        [ qr/--soft/, qr/--map-size/ ], '--soft of an odd map' );
    return;
}

# --light-size and --penumbra-scale.
sub check_soft_number {
    my ( $step, undef, $name ) = @_;
    my ( $soft, $other ) =
      map { draw( $step, '--soft', @$_ ) } [], [ "--$name", 3 ];
    ok( $soft && $other && $soft ne $other,
        "step $step: --$name 3 changes the picture" );
    is_refused( $step, [ "--$name", 3 ],
        [qr/--$name needs --soft: add --soft or drop/],
        "--$name without --soft" );
    return;
}

sub check_hybrid {
    my ($step) = @_;
    my ( $soft, $hybrid ) =
      map { draw( $step, '--soft', @$_ ) } [], ['--hybrid'];
    ok( $soft && $hybrid && $soft ne $hybrid,
        "step $step: --hybrid changes the picture" );
    is_refused( $step, ['--hybrid'],
        [qr/--hybrid needs --soft: add --soft or drop/],
        '--hybrid without --soft' );
    for my $filter (
        [qw(--blur box)], [qw(--radius 2)], [qw(--downsample 2)],
        [qw(--msaa 4)], [qw(--bleed-reduction 0.3)], [qw(--reduction smooth)]
      )
    {
        is_refused(
            $step,
            [ qw(--soft --hybrid), @$filter ],
            [ qr/--hybrid/, qr/$filter->[0]/, qr/drop/ ],
            "--hybrid with @$filter"
        );
    }
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

my %help;

sub help {
    my ($step) = @_;
    return $help{$step} //= run( $step, '--help' );
}

sub options_in_help {
    my ($step) = @_;
    return grep { $_ ne 'help' } help($step)->{out} =~ /^  --([\w-]+)/mg;
}

sub check_help {
    my ($step) = @_;
    my $run = help($step);
    is( $run->{status}, 0, "step $step: --help exits with 0" );
    my @expected =
      grep { has_option( $step, $_ ) } sort keys %OPTIONS;
    is_deeply( [ sort( options_in_help($step) ) ],
        \@expected, "step $step: --help has the options tested here" );

    # What is off, or nowhere, by default has no default to print.
    my @silent = $run->{out} =~ /^  --([\w-]+).*\n(?!.*\(default .+\)$)/mg;
    my @expected_silent =
      grep { !exists $OPTIONS{$_} || has_option( $step, $_ ) }
      qw(adaptive bilinear deferred dump help hybrid keep-all light list-scenes
      mips plan redraw sat shaders slope-term soft window);
    is( join( ' ', sort @silent ),
        "@expected_silent", "step $step: --help prints every default" );
    return;
}

sub has_option {
    my ( $step, $name ) = @_;
    return scalar grep { $_ == $step } @{ $OPTIONS{$name}{steps} };
}

sub check_option {
    my ( $step, $name, $plain ) = @_;
    my $option = $OPTIONS{$name};
    my %values = map { $_ => $option->{$_} // [] } qw(differ same bad);
    if ( $step != $option->{steps}[0] ) {
        my $list = @{ $values{differ} } ? 'differ' : 'bad';
        my @one  = grep { defined } $values{$list}[0];
        %values = ( differ => [], same => [], bad => [] );
        $values{$list} = \@one if !$option->{check};
    }
    $option->{check}->( $step, $plain, $name ) if $option->{check};
    for my $value ( @{ $values{differ} } ) {
        my $picture = draw( $step, "--$name", $value );
        ok( $picture && $picture ne $plain,
            "step $step: --$name $value changes the picture" );
    }
    for my $value ( @{ $values{same} } ) {
        ok( $plain && draw( $step, "--$name", $value ) eq $plain,
            "step $step: --$name $value is the default" );
    }
    for my $value ( @{ $values{bad} } ) {
        is_refused( $step, [ "--$name", $value ],
            [ qr/--$name\b/, $option->{allowed} ],
            "--$name '$value'" );
    }
    return;
}

for my $step ( 1 .. 5 ) {
    check_help($step);
    my $plain = draw($step);
    is( png_size($plain), '160x90', "step $step: draws a picture" );
    for my $name ( sort keys %OPTIONS ) {
        if ( has_option( $step, $name ) ) {
            check_option( $step, $name, $plain );
        }
    }
}

done_testing;
