#!/usr/bin/perl
# Proves that a change moved code and nothing else: 300 sets of options, over
# all steps, scenes and techniques, give the same pictures and dumps to the last
# bit. The first run writes a hash of each set's files into FILE, which belongs
# outside the tree; a run with a FILE that is there compares, and its exit
# status is 1 if a set differs. usage: unmoved.pl FILE [STEP...]
use strict;
use warnings;
use Digest::SHA qw(sha1_hex);
use File::Path qw(make_path remove_tree);
use File::Spec;
use File::Temp qw(tempdir);
use FindBin;
use lib "$FindBin::Bin/lib";
use Pairs;
use VSM;

my $SETS   = 300;
my $SEED   = 20261130;
my @SCENES = qw(teapot teapot:elevation=25 edge edge:gap=1e-3 bleed bleed:r=4
  empty thin fence:pickets=40 grazing avenue avenue:turn=40 stage room
  room:turn=-60 crowd:triangles=3000 unlit offstage lamp lamp:cone=90 enclosed
  headlamp overhead coplanar slivers cut stiff speck teapot:offset=1e6
  teapot:scale=1e-3 empty:elevation=5);
my @SHOWS = qw(visibility depth layer plan mean variance);

# Defaults that may change are spelled out where nothing contradicts them.
my %SPELLED = (
    3 => ['--moments raw'],
    4 => ['--moments raw'],
    5 => [ '--moments central', '--bleed-reduction 0.18' ],
);

sub any { return $_[ int rand @_ ] }

sub fits {
    my ( $item, @set ) = @_;
    return !is_odd_three( @set, $item )
      && !grep { !goes_with( $_, $item ) } @set;
}

# Steps 3 to 5 have more techniques and get more of the sets.
sub next_set {
    my $step  = any( 1, 2, 2, 3, 3, 4, 4, 4, 5, 5, 5, 5, 5 );
    my @items = grep { !/--plan|--show/ } @{ $ITEMS{$step} };
    my @set;
    for ( 1 .. 1 + int rand 4 ) {
        my $item = any(@items);
        push @set, $item if fits( $item, @set );
    }
    push @set, grep { fits( $_, @set ) } @{ $SPELLED{$step} // [] };
    my @words = ( '--scene', any(@SCENES), words_of(@set) );
    push @words, '--show', any( @SHOWS[ 0 .. ( $step < 3 ? 3 : 5 ) ] )
      if rand() < 0.15;
    push @words, '--size', '96x54', '--map-size', any( 64, 96, 128 );
    return ( $step, @words );
}

# Of run.json, times and memory are no part, nor the order of the options,
# nor a radius without a blur.
sub hash_of {
    my ( $run, $folder ) = @_;
    my $all = "status $run->{status} signal $run->{signal}\n";
    for my $file ( everything_below($folder) ) {
        my $bytes = slurp("$folder/$file");
        if ( $file eq 'run.json' ) {
            $bytes =~ s/"map_bytes": \d+|"passes": .*//sg;
            $bytes =~ s/"radius": \d+/"radius": 0/
              if $bytes =~ /"blur": "none"/;
            $bytes = join "\n", sort map { s/,$//r } split /\n/, $bytes;
        }
        $all .= "$file " . sha1_hex($bytes) . "\n";
    }
    return sha1_hex($all);
}

my ( $file, @steps ) = @ARGV;
@ARGV > 0 or die "usage: unmoved.pl FILE [STEP...]\n";
$file = File::Spec->rel2abs($file);
my %before =
  -e $file ? map { reverse /^(\w+) (.*)$/ } split /\n/, slurp($file) : ();
srand $SEED;
my @sets = map { [ next_set(), '--output', 'picture.' . any(qw(png exr)) ] }
  1 .. $SETS;
my $work = tempdir( CLEANUP => 1 );
my ( $text, $differ, $drawn ) = ( '', 0, 0 );
chdir $work or die "$work: $!\n";
for my $number ( 1 .. $SETS ) {
    my ( $step, @words ) = @{ $sets[ $number - 1 ] };
    next if @steps && !grep { $_ == $step } @steps;
    my $name = "$number step$step @words";
    make_path('dump');
    my $run = run_warm( $step, @words, '--dump', 'dump' );
    rename $words[-1], "dump/$words[-1]";
    my $hash = hash_of( $run, 'dump' );
    remove_tree('dump');
    $drawn++ if $run->{status} == 0;
    $text .= "$hash $name\n";
    next if !%before || ( $before{$name} // '' ) eq $hash;
    $differ++;
    print "differs: $name (status $run->{status}: $run->{err})\n";
}
chdir '/';
spew( $file, $text ) if !%before;
print "$drawn drawn, ",
  %before ? "$differ differ\n" : "written to $file\n";
exit( $differ ? 1 : 0 );
