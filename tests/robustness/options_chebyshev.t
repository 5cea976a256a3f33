# Every option that step 5 brings, as in options.t.
use strict;
use warnings;

use File::Temp qw(tempdir);
use Draw;
use Options;
use Test::More;
use VSM;

chdir tempdir( CLEANUP => 1 ) or die "cannot work in a temporary folder\n";

my %OPTIONS = (
    deferred    => { steps => [5], check => \&check_deferred },
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
        differ  => [ '0.6', '0.18' ],
        same    => [0],
        bad     => [ 1,     '-0.1', '' ],
        allowed => qr/numbers from 0 to 0\.9999/,
    },
);

sub check_sat_width {
    my ($step) = @_;
    my @words = qw(--radius 9 --sat --sat-width);
    my ( $fixed, $adaptive ) =
      map { draw( $step, @words, $_ ) } qw(fixed adaptive);
    ok(
        $fixed && $adaptive && $fixed ne $adaptive,
        "step $step: --sat-width adaptive changes the picture"
    );
    is_refused(
        $step,
        [qw(--sat-width adaptive)],
        [qr/--sat-width.*add --sat or drop --sat-width/],
        '--sat-width without --sat'
    );
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
        [qw(--sat)],          [qw(--sampler hardware)],
        [qw(--anisotropy 4)], [qw(--mips --anisotropy 1)]
      )
    {
        my ($name) = grep { /^--[sa]/ } @$other;
        is_refused(
            $step,
            [ '--soft',   @$other ],
            [ qr/--soft/, qr/$name/, qr/drop/ ],
            "--soft with @$other"
        );
    }
    is_refused(
        $step,
        [qw(--soft --map-size 255)],
        [ qr/--soft/, qr/--map-size/ ],
        '--soft of an odd map'
    );
    return;
}

# --light-size and --penumbra-scale.
sub check_soft_number {
    my ( $step, undef, $name ) = @_;
    my ( $soft, $other ) =
      map { draw( $step, '--soft', @$_ ) } [], [ "--$name", 3 ];
    ok(
        $soft && $other && $soft ne $other,
        "step $step: --$name 3 changes the picture"
    );
    is_refused(
        $step,
        [ "--$name", 3 ],
        [qr/--$name needs --soft: add --soft or drop/],
        "--$name without --soft"
    );
    return;
}

sub check_hybrid {
    my ($step) = @_;
    my ( $soft, $hybrid ) =
      map { draw( $step, '--soft', @$_ ) } [], ['--hybrid'];
    ok(
        $soft && $hybrid && $soft ne $hybrid,
        "step $step: --hybrid changes the picture"
    );
    is_refused(
        $step, ['--hybrid'],
        [qr/--hybrid needs --soft: add --soft or drop/],
        '--hybrid without --soft'
    );
    for my $filter ( [qw(--blur box)], [qw(--radius 2)], [qw(--downsample 2)],
        [qw(--msaa 4)], [qw(--bleed-reduction 0.3)],
        [qw(--reduction smooth)] )
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

# Which moments there are where none were asked for. --plan names them, and why.
for (
    [ raw     => 'lose little enough' ],
    [ raw     => 'can be summed or averaged', '--sat' ],
    [ raw     => 'can be summed or averaged', qw(--mips --sampler hardware) ],
    [ raw     => 'can be summed or averaged', qw(--sat --format rg16f) ],
    [ central => 'need 32 bits',              qw(--format rg16f) ],
    [ central => 'lose too much in mip-maps', '--mips' ],
    [ central => 'lose too much in mip-maps', '--soft' ],
    [ central => '--moments',                 qw(--moments central) ],
  )
{
    my ( $moments, $why, @options ) = @$_;
    is(
        draw( 5, @options ) // '',
        draw( 5, @options, '--moments', $moments ),
        "step 5 @options: $moments moments by itself"
    );
    my $decision = $moments eq 'raw' ? 'left out' : 'kept';
    like(
        run( 5, '--plan', @options )->{out},
        qr/^central moments +$decision .*$why$/m,
        "step 5 @options: --plan says so"
    );
}

test_options( \%OPTIONS, 5 );
done_testing;
