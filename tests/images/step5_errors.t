# The numbers of an error, made again from the pictures that they are about:
# RMSE, 99th percentile, largest, share over 1/255, mean.
use strict;
use warnings;
use List::Util qw(max sum0);
use Test::More;
use VSM;

my @small = qw(--size 160x90 --map-size 128);

# The pictures lie in the dump's w/.
sub rows_of {
    my ($dump) = @_;
    return oracle_errors( $dump, 'rays=16', "write=$dump/w",
        "pictures=$dump/w" );
}

# A picture's pixels, a list of channels each.
sub pixels_of {
    my ($file) = @_;
    my $run = command( '/usr/bin/env', 'oiiotool', '--dumpdata', $file );
    return map { [ split ' ' ] } $run->{out} =~ /^ +Pixel [^:]+: ([^(\n]+)/mg;
}

# The table has six digits, of which the last may be rounded another way.
sub is_about {
    my ( $found, $wanted, $name ) = @_;
    return ok( abs( $found - $wanted ) <= 1e-5 * abs $wanted,
        "$name: $found, $wanted" );
}

my $dump    = dump_run( 5, '--scene', 'teapot', @small );
my %rows    = rows_of($dump);
my @program = map { $_->[0] } pixels_of("$dump/visibility.exr");
for my $truth (qw(footprint hard)) {
    my $row    = $rows{$truth};
    my $count  = $row->{pixels};
    my @errors = unpack 'f*', slurp("$dump/w/error.$truth.bin");
    my @truth  = map { $_->[0] } pixels_of("$dump/w/truth.$truth.exr");
    is( scalar @errors, 160 * 90, "$truth: a picture of errors" );

    # Nine digits are read; where a pixel is not counted there is no error.
    my @difference = map { $program[$_] - $truth[$_] } 0 .. $#errors;
    my @unlike =
      grep { abs( $errors[$_] - $difference[$_] ) > 1e-6 } 0 .. $#errors;
    is( ( grep { $errors[$_] != 0 } @unlike ),
        0, "$truth: the error is the program minus the truth" );
    cmp_ok( scalar @unlike, '<=', $row->{apart},
        "$truth: but for the pixels that are apart" );

    # Those that are not counted are 0: they do not change the sums, and stand
    # last where the largest is first.
    my @sizes = sort { $b <=> $a } map { abs } @errors;
    is_about( $row->{rmse}, sqrt( sum0( map { $_**2 } @errors ) / $count ),
        "$truth: RMSE" );
    is_about( $row->{max}, $sizes[0], "$truth: largest" );
    is_about( $row->{mean}, sum0(@errors) / $count, "$truth: mean" );
    is_about(
        $row->{share},
        ( grep { $_ > 1 / 255 } @sizes ) / $count,
        "$truth: share over 1/255"
    );
    my $over = ( grep { $_ > $row->{p99} * ( 1 + 1e-5 ) } @sizes ) / $count;
    my $from = ( grep { $_ > $row->{p99} * ( 1 - 1e-5 ) } @sizes ) / $count;
    ok( $over <= 0.01 && $from > 0.01,
        "$truth: 99th percentile: $row->{p99}; over it $over, not under $from"
    );
}

# As a picture: blue is too dark, red too light.
my @errors = unpack 'f*', slurp("$dump/w/error.footprint.bin");
my @colour = pixels_of("$dump/w/difference.png");
my @wrong  = grep {
    my ( $red, undef, $blue ) = @{ $colour[$_] };
    abs $errors[$_] > 0.05 && ( $errors[$_] > 0 ? $red < $blue : $red > $blue );
} 0 .. $#errors;
cmp_ok( max( map { abs } @errors ), '>', 0.05, 'some errors are to be seen' );
is( "@wrong", '', 'blue where it is too dark, red where it is too light' );

sub shown_in {
    my ($dump) = @_;
    my @normals = pixels_of("$dump/normal.exr");
    return scalar grep { grep { $_ != 0 } @$_ } @normals;
}

# Counted is what shows an object, and not the background; all of this one
# faces the light.
$dump = dump_run( 1, '--scene', 'bleed', @small );
my $shown = shown_in($dump);
%rows = rows_of($dump);
is( $rows{hard}{pixels}, $shown, 'what shows an object counts' );
cmp_ok( $shown, '<', 160 * 90, 'and something does not' );

# And here the light comes in at less than N.L = 0.1.
$dump = dump_run( 1, '--scene', 'grazing', @small );
%rows = rows_of($dump);
is( "$rows{hard}{pixels} $rows{hard}{apart}",
    '0 ' . shown_in($dump), 'silhouettes are apart' );

done_testing;
