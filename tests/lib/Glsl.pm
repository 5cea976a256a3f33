# What shader files need from each other and offer each other: as their code has
# it, and as the comments say that they begin with.
package Glsl;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(needed defined_in told);

my $TYPE = qr/(?:void|bool|int|uint|float|[biu]?vec[234]|mat[234](?:x[234])?
    |[iu]?(?:sampler|image)\w+|[A-Z]\w*[a-z]\w*)/x;
my %theirs = map { $_ => 1 } qw(
  const uniform in out inout flat centroid struct if else for while do switch
  case default break continue discard return true false readonly writeonly
  abs acos all any asin atan barrier ceil clamp cos cosh cross dFdx dFdy degrees
  determinant distance dot equal exp exp2 faceforward floatBitsToInt
  floatBitsToUint floor fract fwidth greaterThan greaterThanEqual imageLoad
  imageSize imageStore intBitsToFloat inverse inversesqrt isinf isnan length
  lessThan lessThanEqual log log2 matrixCompMult max memoryBarrier min mix mod
  modf normalize not notEqual outerProduct pow radians reflect refract round
  roundEven sign sin sinh smoothstep sqrt step tan tanh texelFetch texture
  textureGather textureGrad textureLod textureOffset textureSize transpose
  trunc uintBitsToFloat EmitVertex EndPrimitive);

# Without comments, numbers, what follows a dot, and layout qualifiers.
sub code {
    my ($text) = @_;
    $text =~ s{//.*}{}g;
    $text =~ s/^#\w+//mg;
    $text =~ s/\blayout\([^)]*\)( in;| out;)?//g;
    $text =~ s/\b[0-9][0-9a-fx.]*(?:e-?[0-9]+)?u?\b//g;
    $text =~ s/\.\s*\w+//g;
    return $text;
}

# Its functions, as [name, parameters, body]; and what is left.
sub parts {
    my ($text) = @_;
    my $code = code($text);
    my @functions;
    push @functions, [ $1, $2, $3 ]
      while $code =~ s/^$TYPE (\w+)\(([^)]*)\)\s*\{\n(.*?)^\}//ms;
    return ( $code, @functions );
}

# The names that a text declares.
sub declared {
    my ($text) = @_;
    my @names;
    while ( $text =~ /\b$TYPE (\w+)\b(?!\()(?=([^;()]*))/g ) {
        my ( $first, $rest ) = ( $1, $2 );
        push @names, $first, $rest =~ /,\s*(\w+)(?=\s=|,|\z)/g;
    }
    return @names;
}

# What a file defines for itself and for others: functions, structs, variables.
sub defined_in {
    my ($text) = @_;
    my ( $rest, @functions ) = parts($text);
    my @structs = $rest =~ /^struct (\w+)/mg;
    $rest =~ s/^struct .*?^\};//msg;
    $rest =~ s/^$TYPE \w+\([^)]*\);//mg;    # declared for another file
    return ( @structs, ( map { $_->[0] } @functions ), declared($rest) );
}

# The names that a file uses and does not define, each once.
sub needed {
    my ($text) = @_;
    my ( $rest, @functions ) = parts($text);
    my %own = map { $_ => 1 } defined_in($text);
    my ( %seen, @names );
    my $look = sub {
        my ( $code, @local ) = @_;
        my %local = map { $_ => 1 } @local;
        for my $name ( $code =~ /\b([A-Za-z]\w*)\b/g ) {
            my $builtin = $theirs{$name} || $name =~ /^gl_|^$TYPE\z/;
            $builtin = 0 if $name =~ /^[A-Z]/ && !$theirs{$name};
            next if $builtin || $own{$name} || $local{$name};
            push @names, $name if !$seen{$name}++;
        }
    };

    # Of members, and of what is declared for another file, the types.
    $rest =~ s/^(struct .*?^\};)/ join ' ', $1 =~ m{^    ($TYPE) }mg /gems;
    $rest =~ s/^$TYPE \K(\w+)\(([^)]*)\);/ "$1 @{[ $2 =~ m{($TYPE) }g ]}" /gem;
    $look->($rest);
    for (@functions) {
        my ( undef, $parameters, $body ) = @$_;
        $look->( "$parameters;$body", declared("$parameters;$body") );
    }
    return @names;
}

# What the comment says that a file begins with, and no other text does: the
# needed names, those among them that a C file puts in front, that C file, and
# the offered names. Nothing where it does not say so.
sub told {
    my ($text) = @_;
    my ( $needs, $offers ) = $text =~ m{
        \A//\ (?!needs:).*\n (?://.*\n)*?
        //\ needs:\ ((?:.*\n//\ \ )*.*)\n
        //\ offers:\ ((?:.*\n//\ \ )*.*)\n\n}x
      or return;
    my ( $names, $from, $constants ) =
      $needs =~ m{\A(.*?)(?:;\s(?://\s+)?|\A)from (\w+\.c):\n(.*)\z}s
      ? ( $1, $2, $3 )
      : ( $needs, '', '' );
    my @front = $constants =~ m{^//\s+const \w+ (\w+)}mg;
    my @names = $names eq 'nothing' ? () : split m{,\s+(?://\s+)?}, $names;
    return {
        needs  => [ @names, @front ],
        front  => \@front,
        from   => $from,
        offers => [ split m{,\s+(?://\s+)?}, $offers ],
    };
}

1;
