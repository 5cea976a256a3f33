# The walls of the ground floor: rooms of at most 16 files, which use the rooms
# before them in base.mk's list and no other, and nothing of a step. What leaves
# out is in its room: a stage knows its target's question and nothing else.
use strict;
use warnings;
use File::Glob qw(bsd_glob);
use Test::More;
use VSM;

my $base = 'step1_shadowmap/base';
my $lists = slurp( root() . "/$base/base.mk" );
my ($lesson) = $lists =~ /^lesson_rooms := (.*)/m;
my ($others) = $lists =~ /^base_rooms := \$\(lesson_rooms\) (.*)/m;
my @rooms = map { split ' ', $_ // '' } $lesson, $others;
my %place = map { $rooms[$_] => $_ } 0 .. $#rooms;
cmp_ok( @rooms, '>', 5, 'base.mk lists the rooms' );

# What a file of ours includes.
sub includes { return $_[0] =~ /^#include "(.*?)"/mg }

for my $room (@rooms) {
    my @files = bsd_glob( root() . "/$base/$room/*" );
    cmp_ok( @files, '>', 0,  "$room is there" );
    cmp_ok( @files, '<', 17, "$room has at most 16 files" );
    my ( @back, @steps );
    for my $file ( grep { -f } @files ) {
        my $text = slurp($file);
        for ( includes($text) ) {
            push @steps, "$file: $_" if !m{^$base/};
            my ($other) = m{^$base/(\w+)/} or next;
            push @back, "$file: $_"
              if ( $place{$other} // 99 ) > $place{$room};
        }
        my $code = $text =~ s{//.*|/\*.*?\*/}{}gr;
        push @steps, "$file: $1" if $code =~ /("[^"\n]*\bstep[2-5]_\w*)/;
    }
    is( "@back",  '', "$room uses only the rooms before it" );
    is( "@steps", '', "$room knows no step" );
}

for my $room ( grep { -d } bsd_glob( root() . '/tests/oracle/*' ) ) {
    my @files = bsd_glob("$room/*");
    cmp_ok( @files, '<', 17, "$room has at most 16 files" );
}

# leave_out's names, by its own headers.
my %names;
for my $header ( bsd_glob( root() . "/$base/leave_out/*.h" ),
    root() . "/$base/run/extras.h" )
{
    my $text = slurp($header) =~ s{//.*}{}gr;
    $names{$_} = 1 for $text =~ /\b([a-z]\w+)\(/g, $text =~ /^\} (\w+);/mg;
}
cmp_ok( keys %names, '>', 5, 'leave_out has names' );
my $any = join '|', keys %names;
my @told;
for my $file ( bsd_glob( root() . '/step*/*.[ch]' ) ) {
    my $code = slurp($file) =~ s{//.*}{}gr;
    push @told, "$file: $1" if $code =~ /\b($any|keep_all|redraw)\b/;
}
is( "@told", '', 'no stage has a name of leave_out' );

# Counted, compiled again and dumped whole in one place each.
for (
    [ 'touch'         => qr/\btouch\(/,         'measure/count.c' ],
    [ 'reload'        => qr/\bgl_reload\(/,     'run/run.c' ],
    [ 'whole maps'    => qr/leave_out_nothing\(/, 'run/run.c' ],
  )
{
    my ( $what, $call, $where ) = @$_;
    my @places = grep {
        slurp($_) =~ /^ +(?:\S.*)?$call/m
    } bsd_glob( root() . '/step*/*.c' ), bsd_glob( root() . "/$base/*/*.c" );
    s{.*/$base/}{} for @places;
    is( "@places", $where, "$what in one file" );
}

done_testing;
