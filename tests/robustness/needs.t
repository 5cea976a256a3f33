# Every shader file begins with what it does, needs from others and offers to
# them; and that is so.
use strict;
use warnings;

use Glsl qw(defined_in needed told);
use Test::More;
use VSM;

my ( %text, %told, %offered, %c );
for my $step ( map { program_name($_) } 1 .. 5 ) {
    for my $file ( everything_below( root() . "/$step" ) ) {
        my $name = "$step/$file";
        $c{$1}       = slurp( root() . "/$name" ) if $file =~ m{([^/]+\.c)\z};
        $text{$name} = slurp( root() . "/$name" )
          if $file =~ /\.(?:glsl|vert|geom|frag|comp)\z/;
    }
}
cmp_ok( keys %text, '>', 100, 'there are shaders' );
for my $file ( sort keys %text ) {
    $told{$file} = told( $text{$file} );
    ok( $told{$file}, "$file begins with needs: and offers:" );
    $offered{$_}{$file} = 1 for @{ $told{$file}{offers} };
}

for my $file ( sort grep { $told{$_} } keys %told ) {
    my $told = $told{$file};
    is(
        join( ' ', sort @{ $told->{needs} } ),
        join( ' ', sort( needed( $text{$file} ) ) ),
        "$file: what it needs"
    );
    my %own   = map { $_ => 1 } 'gl_Position', defined_in( $text{$file} );
    my @wrong = grep { !$own{$_} } @{ $told->{offers} };
    is( "@wrong", '', "$file: defines what it offers" );

    # A file in whose place this one stands may say what C puts in front.
    my %front   = map { $_ => 1 } map { @{ $_->{front} } } values %told;
    my @missing = grep { !$front{$_} && !$offered{$_} } @{ $told->{needs} };
    is( "@missing", '', "$file: others offer what it needs" );
    my $c = $c{ $told->{from} } // '';
    my @unknown = grep { $c !~ /\b$_\b/ } @{ $told->{front} };
    is( "@unknown", '', "$file: $told->{from} knows what it puts in front" );
}

done_testing;
