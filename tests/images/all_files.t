# A picture as PNG is the one as EXR, in sRGB with 8 bits: OpenImageIO, with
# which the programs write neither, reads both and converts the one to the
# other. Where a value is between two of 8 bits either is right.
use strict;
use warnings;
use File::Temp qw(tempdir);
use Test::More;
use VSM;

of_steps( 1, 5 );

my $folder = tempdir( CLEANUP => 1 );
my @small  = qw(--size 95x54 --map-size 64);

for my $step ( grep { is_chosen($_) } 1, 5 ) {
    for my $name ( 'a.png', 'a.exr' ) {
        my $run = run( $step, @small, '--output', "$folder/$name" );
        is( $run->{status}, 0, "step $step: $name" ) or diag( $run->{err} );
    }
    my $converted = command(
        'oiiotool', "$folder/a.exr", qw(--clamp:min=0:max=1 --colorconvert),
        qw(linear sRGB -d uint8 -o), "$folder/b.png"
    );
    is( $converted->{status}, 0, "step $step: converted" )
      or diag( $converted->{err} );
    my $difference = command( qw(oiiotool --fail 0.004 --diff),
        "$folder/a.png", "$folder/b.png" );
    is( $difference->{status}, 0, "step $step: the same picture" )
      or diag( $difference->{out} );
}

done_testing();
