# The README's table of techniques promises an option, a step and a test for
# each: that they exist, that the step says something about it, and that the
# test uses the option. A technique's folder says what it is for and shows it.
use strict;
use warnings;

use Test::More;
use VSM;

my $readme = slurp( root() . '/README.md' );
my ($table) = $readme =~ /^## Every technique[^|]*((?:\|.*\n)+)/m
  or die "README.md has no table of techniques\n";
my @rows = map { [ split /\s*\|\s*/, $_ ] } split /\n/, $table;
my @head = splice @rows, 0, 2;
is( "@{$head[0]}", ' technique post option step test', 'the columns' );
ok( @rows >= 20, @rows . ' techniques' );

my %posts = map { $_ => 1 } 'all', $readme =~ /^\* \*\*(.*?)\*\*, /mg;
my ( %help, %seen );
for my $row (@rows) {
    my ( undef, $name, $post, $option, $step, $test ) = @$row;
    ok( !$seen{$name}++, "$name: once" );
    my @unknown = grep { !$posts{$_} } split /, /, $post;
    ok( !@unknown, "$name: a post" ) or diag("@unknown");
    my ( $flag, $value ) = $option =~ /^`(--[a-z-]+)(?: ([\w.]+))?`$/
      or fail("$name: $option is an option") and next;
    $help{$step} //= run( $step, '--help' )->{out};
    my ($choices) = $help{$step} =~ /^  \Q$flag\E (.*)$/m;
    ok( defined $choices, "$name: step $step has $flag" ) or next;
    my $known = !defined $value || $choices !~ /,/ || $choices =~ /\b$value\b/;
    ok( $known, "$name: $flag takes " . ( $value // 'any' ) );
    my $words = join '', map { slurp($_) }
      map { matching( root(), "step${step}_*/$_" ) } '*.md',
      'techniques/*/README.md', 'base/leave_out/README.md';
    like( $words, qr/\Q$flag\E\b/, "$name: step $step says what $flag is for" );
    like( $words, qr/\b$value\b/, "$name: step $step says what $value is" )
      if defined $value;
    my $file = root() . "/$test";
    ok( -e $file && $test =~ m{^tests/.*\.t$}, "$name: $test exists" ) or next;
    like( slurp($file), qr/\Q$flag\E\b|^    '?@{[ substr $flag, 2 ]}'? +=>/m,
        "$name: $test uses $flag" );
    like( slurp($file), qr/\b$value\b/, "$name: $test uses $value" )
      if defined $value;
}

# What several share is no technique of its own, and says so.
for my $folder ( grep { -d } matching( root(), 'step*/techniques/*' ) ) {
    my ( $all, $name ) = $folder =~ m{(.*)/(.*)};
    my ( $readme, $list ) = map { -e $_ ? slurp($_) : '' }
      map { "$_/README.md" } $folder, $all;
    if ( $name eq 'shared' ) {
        like( $readme, qr/^No technique of its own/m, "$folder: says so" );
        next;
    }
    like( $list, qr/\]\(\Q$name\E\/\)/, "$name: in its step's list" );
    like( $readme, qr/^# .*`--/, "$name: its README begins with an option" );
    like( $readme, qr/^!\[.+\]\(picture[.]png\)$/m, "$name: and a picture" );
    like( $readme, qr/^\* \*\*$_\*\* /m, "$name: and says: $_" )
      for qw(Cures Costs Not);
}

done_testing;
