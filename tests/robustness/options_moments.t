# Every option that steps 3 and 4 bring, as in options.t.
use strict;
use warnings;

use File::Path qw(remove_tree);
use File::Temp qw(tempdir);
use Draw;
use Options;
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

my %OPTIONS = (
    format => {
        steps   => [ 3 .. 5 ],
        same    => ['rg32f'],
        check   => \&check_format,
        bad     => [ 'rg8', 'auto', '' ],
        allowed => qr/rg32f/,
    },
    depth => {
        steps   => [ 3 .. 5 ],
        same    => [qw(linear projected)],            # of a directional light
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
            is_refused(
                $step,
                [qw(--mips --map-size 255)],
                [ qr/--mips/, qr/--map-size/ ],
                '--mips of an odd map'
            );
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
);

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
    ok(
        $off && $plane && $next && $off ne $plane && $off ne $next,
        "step $step: --slope-term changes the variance"
    );
    is_refused(
        $step, [qw(--slope-from plane)],
        [qr/--slope-from plane needs --slope-term: add.*or drop/],
        '--slope-from without --slope-term'
    );
    is_refused(
        $step,
        [qw(--slope-term --slope-from derivatives --msaa 4)],
        [qr/--slope-from derivatives.*--msaa 4.*drop one/],
        'derivatives with --msaa'
    );
    return;
}

# What the driver cannot make it says; --dump writes what is resolved.
# Raw is the default; and in 16 bits raw moments have no variance left.
sub check_moments {
    my ( $step, $plain ) = @_;
    is( draw( $step, qw(--moments raw) ),
        $plain, "step $step: --moments raw changes nothing" );
    my ( $raw, $central ) =
      map { draw( $step, qw(--show variance --format rg16f --moments), $_ ) }
      qw(raw central);
    ok( $raw && $central && $raw ne $central,
        "step $step: --moments central keeps a variance that raw lost" );
    return;
}

sub check_msaa {
    my ($step) = @_;
    is_refused(
        $step, [qw(--msaa 64)],
        [qr/--msaa 64.*driver's limit of \d+ samples/],
        'more samples than the driver has'
    );
    is_refused(
        $step,
        [qw(--msaa 3)],
        [
qr/--msaa 3: this driver makes (\d+) samples.*give \1, or drop --msaa/
        ],
        'a number of samples that the driver does not have'
    );
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
    is_refused(
        $step, [qw(--anisotropy 4)],
        [qr/--anisotropy.*add --mips or drop/],
        '--anisotropy without --mips'
    );
    return;
}

# The same box as the blur's, from other sums.
sub check_sat {
    my ($step) = @_;
    my ( $blur, $table ) =
      map { draw( $step, qw(--show variance --size 320x180), @$_ ) } [],
      ['--sat'];
    ok(
        $blur && $table && $blur ne $table,
        "step $step: --sat changes the picture"
    );
    is_refused(
        $step, [qw(--sat --mips)],
        [qr/--sat.*--mips.*drop one/],
        '--sat with --mips'
    );
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
    my ( $explicit, $hardware ) =
      map { draw( $step, @words, $_ ) } qw(explicit hardware);
    ok(
        $explicit && $hardware && $explicit ne $hardware,
        "step $step: --sampler hardware changes the picture"
    );
    is_refused(
        $step, [qw(--sampler hardware)],
        [qr/--sampler hardware.*add --mips or drop --sampler/],
        '--sampler without --mips'
    );
    is_refused(
        $step,
        [ qw(--scene room --mips --anisotropy 8 --sampler), 'hardware' ],
        [qr/--sampler hardware.*--anisotropy.*one layer.*drop one/],
        'taps of the texture unit next to another layer'
    );
    local $ENV{MESA_EXTENSION_OVERRIDE} = '-GL_EXT_texture_filter_anisotropic';
    is_refused(
        $step,
        [ qw(--mips --anisotropy 8 --sampler), 'hardware' ],
        [qr/--sampler hardware.*--anisotropy.*drop one/],
        'what the driver cannot sample'
    );
    return;
}

# The same picture; where the driver has no compute shaders, the choice is made
# or refused. Mesa can be told to be an older driver.
sub check_sat_by {
    my ($step) = @_;
    my @words = qw(--sat --sat-by);
    my ( $auto, $compute, $fragments ) =
      map { draw( $step, @words, $_ ) } qw(auto compute fragments);
    ok(
        $auto && $auto eq $compute && $auto eq $fragments,
        "step $step: --sat-by does not change the picture"
    );
    is_planned( $step, 'summed-area table', @$_ )
      for [ 'compute', '--sat' ], [ 'fragments', @words, 'fragments' ];
    is_refused(
        $step, [qw(--sat-by compute)],
        [qr/--sat-by compute.*add --sat or drop --sat-by/],
        '--sat-by without --sat'
    );
    local $ENV{MESA_GL_VERSION_OVERRIDE} = '3.3';
    is_refused(
        $step,
        [ @words, 'compute' ],
        [qr/--sat-by compute.*4\.3.*drop --sat-by/],
        '--sat-by compute without OpenGL 4.3'
    );
    ok(
        draw( $step, '--sat' ) eq $auto,
        "step $step: --sat without OpenGL 4.3"
    );
    return;
}

# The same filter, rounded in another order; where the driver has no compute
# shaders, the choice is made or refused.
# Who does a pass, as --plan says.
sub is_planned {
    my ( $step, $pass, $by, @options ) = @_;
    my $run =
      run( $step, qw(--size 160x90 --output planned.png --plan), @options );
    like(
        $run->{out},
        qr/^$pass .* by $by/m,
        "step $step @options: --plan says by $by"
    );
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
            $step,
            [ @$other, qw(--blur-by compute) ],
            [qr/--blur-by compute.*@$other.*drop one/],
            "--blur-by compute with @$other"
        );
    }
    is_refused(
        $step,
        [qw(--sat --blur-by fragments)],
        [qr/--blur-by fragments.*--sat.*drop one/],
        '--blur-by with --sat'
    );
    local $ENV{MESA_GL_VERSION_OVERRIDE} = '3.3';
    is_refused(
        $step, [qw(--blur-by compute)],
        [qr/--blur-by compute.*4\.3.*drop --blur-by/],
        '--blur-by compute without OpenGL 4.3'
    );
    is( draw( $step, @words, 'auto' ),
        $fragments, "step $step: --blur-by auto without OpenGL 4.3" );
    return;
}

test_options( \%OPTIONS, 3, 4 );
done_testing;
