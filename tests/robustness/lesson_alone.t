# A lesson stands alone: no file of it has a name of a technique, nor of what
# the ground floor can do without; and it holds nothing that only those use.
use strict;
use warnings;

use File::Basename qw(basename);
use Lists;
use Test::More;
use VSM;

my @steps = map { program_name($_) } 1 .. 5;
my $base  = 'step1_shadowmap/base';
my $GLSL  = qr/\.(?:glsl|vert|geom|frag|comp)\z/;

sub sources_below {
    my ($folder) = @_;
    return map { "$folder/$_" }
      grep { /\.[ch]\z|$GLSL/ } everything_below( root() . "/$folder" );
}

# The lessons, the rooms that they stand on, and what they do not need.
my @lesson     = map { made_list("${_}_lesson") } @steps;
my %room       = map { $_ => 1 } made_list('lesson_rooms');
my @more       = map { "$base/$_" } grep { !$room{$_} } made_list('base_rooms');
my @techniques = grep { -d root() . "/$_" } map {
    my $all = "$_/techniques";
    map { "$all/" . basename($_) } matching( root(), "$all/*" )
} @steps;
my @floor = map { sources_below("$base/$_") } keys %room;
push @floor, grep { $_ =~ $GLSL } made_list('base_rest');
my @others = map { sources_below($_) } @techniques, @more;
my %code   = map { $_ => slurp( root() . "/$_" ) =~ s{//.*}{}gr } @lesson,
  @floor, @others;
cmp_ok( @techniques, '>', 15, 'there are techniques' );
cmp_ok( @more,       '>', 1,  'and rooms that a lesson can do without' );

sub is_glsl { return $_[0] =~ $GLSL }

# --- names -------------------------------------------------------------------

# The functions, types and constants that a file offers to others.
sub offered {
    my ($file) = @_;
    my $text = $code{$file};
    if ( is_glsl($file) ) {
        return if $file !~ /glsl\z/;
        return $text =~ /^[a-z]\w+ (\w+)\(/mg, $text =~ /^struct (\w+)/mg;
    }
    my @names = (
        $text =~ /^(?!static|typedef)[a-zA-Z][\w ]* [*]?(\w+)\(/mg,
        $text =~ /^(?:\} |struct |enum )([A-Z]\w+)/mg
    );
    push @names, $1 =~ /\b([A-Z]\w+)/g
      while $text =~ /\benum(?: \w+)? \{(.*?)\}/sg;
    return @names;
}

# Words of a technique that are the lesson's too, and of what.
my %ours = map { $_ => 1 } (
    ( map { split /_/ } @steps ),
    'light',       # whose map it is
    'depth',       # what a map holds
    'slope',       # of a surface, for its bias
    'half',        # a kernel
    'bilinear',    # between texels
    'guard',       # the lesson has a closed form of one
);
my %folder = map { basename($_) => 1 } @techniques, @more;
my %option = map { tr/-/_/r => 1 }
  map { $code{$_} =~ /\.name = "([\w-]+)"/g } @others;
delete @folder{ keys %ours, 'shared' };
delete @option{ keys %ours };

for my $glsl ( 0, 1 ) {
    my ( $own, $other ) = map {
        [ map { offered($_) } grep { is_glsl($_) == $glsl } @$_ ]
    } [ @lesson, @floor ], \@others;
    my %other = map { $_ => 1 } @$other;
    delete @other{ @$own, 'main' };
    cmp_ok( keys %other, '>', 20, ( $glsl ? 'GLSL' : 'C' ) . ': their names' );
    for my $file ( grep { is_glsl($_) == $glsl } @lesson ) {

        # Of strings, options and paths. Others are for people.
        my $text = $code{$file} =~ s/"[^"\n]* [^"\n]*"//gr;
        $text =~ s/("[^"\n]*")/ $1 =~ tr{-}{_}r /ge;
        my %found;
        for my $name ( $text =~ /\b([a-z]\w*)/gi ) {
            my @words = map { lc } $name =~ /[A-Z]?[a-z]+|[A-Z]+/g;
            $found{$name} = 1
              if $other{$name}
              || $option{$name}
              || grep { $folder{$_} } $name, @words;
        }
        is( join( ' ', sort keys %found ),
            '', "$file: no name of a technique" );
    }
}

# --- uses --------------------------------------------------------------------

# A member that lessons never read, or a variable that they only count up, is
# there for others.
for my $file ( grep { /\.(?:h|glsl)\z/ } @lesson ) {
    my @readers = grep { is_glsl($_) == is_glsl($file) } @lesson,
      is_glsl($file) ? @floor : ();
    my $read = join "\n", @code{@readers};
    my @unread;
    while ( $code{$file} =~ /struct (?:\w+ )?\{(.*?)\n\}/sg ) {
        my @members = $1 =~ /(\w+)(?:\[\w+\])*(?:[,;]|\)\()/g;
        push @unread, grep { $read !~ /(?:\.|->)$_\b/ } @members;
    }
    if ( is_glsl($file) ) {
        for my $name ( $code{$file} =~ /^\w+ (\w+) = [^;]*;/mg ) {
            push @unread, $name
              if $read =~ s/\b$name(?: = [^;]*|\+\+);//gr !~ /\b$name\b/;
        }
    }
    is( "@unread", '', "$file: all its members and variables are read" );
}

my $nested = qr/(?<nested>\((?:[^()]++|(?&nested))*+\))/;
my $type   = qr/[a-zA-Z]\w+ (?:[\w ]+ )?[*]?/;

# How some files call a function: for each call the text before it in its
# statement, and its arguments.
sub calls {
    my ( $name, @files ) = @_;
    my @calls;
    for my $text ( @code{@files} ) {
        while ( $text =~ /([^;{}]*)\b$name($nested)/g ) {
            my ( $before, $inside ) = ( $1, substr $2, 1, -1 );
            next if $before =~ /^$type\z/m;    # it is defined
            my @arguments;
            push @arguments, $1 while $inside =~ /\s*((?:[^,()]++|$nested)+)/g;
            push @calls, [ $before, @arguments ];
        }
    }
    return @calls;
}

# What lessons always say in the same way, and others in another.
my %known = (
    'map_coordinates 3' => 'a light sees through views, a layer each',
);
my $LITERAL = qr/\A(?:-?[\d.]+(?:e-?\d+)?|NULL|true|false)\z/;

sub check_function {
    my ( $file, $type, $name, $mine, $theirs ) = @_;
    my @mine   = calls( $name, @$mine );
    my @theirs = calls( $name, @$theirs );
    ok( @mine > 0, "$file: a lesson calls $name" ) or return;
    for my $i ( 1 .. $#{ $mine[0] } ) {
        my $value = $mine[0][$i];
        next if $value !~ $LITERAL || grep { $_->[$i] ne $value } @mine;
        next if $known{"$name $i"};
        ok( ( !grep { $_->[$i] ne $value } @theirs ),
            "$file: argument $i of $name is not for others" );
    }
    return if $type =~ /^void\b/ || grep { $_->[0] =~ /\S/ } @mine;
    ok( ( !grep { $_->[0] =~ /\S/ } @theirs ),
        "$file: the result of $name is not for others" );
    return;
}

for my $file ( grep { /\.(?:h|glsl)\z/ } @lesson ) {
    my ( $mine, $theirs ) = map {
        [ grep { is_glsl($_) == is_glsl($file) } @$_ ]
    } [ @lesson, @floor ], \@others;
    my @functions = $code{$file} =~ /^($type)(\w+)\(/mg;
    while ( my ( $result, $name ) = splice @functions, 0, 2 ) {
        check_function( $file, $result, $name, $mine, $theirs );
    }
}

done_testing;
