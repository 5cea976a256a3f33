# What the guides point to is there: every link of every README and the documents
# beside them, and where it names a heading, that.
use strict;
use warnings;

use File::Basename qw(dirname);
use Test::More;
use VSM;

# The name that a heading gets on a page.
sub anchor {
    my ($heading) = @_;
    return lc( $heading =~ s/[^\w -]//gr ) =~ tr/ /-/r;
}

my @guides =
  map { matching( root(), $_ ) } map { ( "$_*.md", "$_*/*.md" ) } '', 'tests/',
  'step*/techniques/', 'step*/base/';
ok( @guides >= 30, @guides . ' guides' );
for my $guide (@guides) {
    my $name  = $guide =~ s{^\Q${\root()}\E/}{}r;
    my $text  = slurp($guide);
    my @links = ( $text =~ /\]\(([^)\s]+)\)/g, $text =~ /(?:href|src)="(.*?)"/g );
    for my $link ( grep { !/^\w+:/ } @links ) {
        my ( $path, $place ) = split /#/, $link;
        my $target =
          $path eq '' ? $guide : dirname($guide) . "/$path";
        ok( -e $target, "$name: $link is there" ) or next;
        next if !defined $place;
        my @anchors = map { anchor($_) } slurp($target) =~ /^#+ (.*)/mg;
        ok( ( grep { $_ eq $place } @anchors ), "$name: $link is a heading" );
    }
}

done_testing;
