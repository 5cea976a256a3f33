# For the tests of the options: a good value works and does something, a bad
# one is refused in one line that says what is allowed, and then nothing is
# written. The options are read from --help, so that a new one without an entry
# in a test's table fails. Works in the current directory.
package Options;

use strict;
use warnings;

use Exporter   qw(import);
use List::Util qw(first);
use Test::More;
use Draw;
use VSM;

our @EXPORT = qw(test_options options_in_help);

my %help;

sub help {
    my ($step) = @_;
    return $help{$step} //= run( $step, '--help' );
}

sub options_in_help {
    my ($step) = @_;
    return grep { $_ ne 'help' } help($step)->{out} =~ /^  --([\w-]+)/mg;
}

# The first program that has the option.
sub brought_by {
    my ($name) = @_;
    return first {
        grep { $_ eq $name }
          options_in_help($_)
    } 1 .. 5;
}

sub has_option {
    my ( $option, $step ) = @_;
    return scalar grep { $_ == $step } @{ $option->{steps} };
}

# Of the options that these steps bring.
sub check_help {
    my ( $options, $step, @bring ) = @_;
    my $run = help($step);
    is( $run->{status}, 0, "step $step: --help exits with 0" );
    my @own = grep {
        my $by = brought_by($_);
        grep { $_ == $by } @bring
    } options_in_help($step);
    is_deeply(
        [ sort @own ],
        [ grep { has_option( $options->{$_}, $step ) } sort keys %$options ],
        "step $step: --help has the options tested here"
    );

    # What is off, or nowhere, by default has no default to print.
    my %silent =
      map { $_ => 1 } $run->{out} =~ /^  --([\w-]+).*\n(?!.*\(default .+\)$)/mg;
    my %expected = map { $_ => 1 }
      qw(adaptive bilinear deferred dump hybrid keep-all light list-scenes
      mips move plan print-shader redraw sat shaders slope-term soft window);
    is(
        join( ' ', grep { $silent{$_} } sort @own ),
        join( ' ', grep { $expected{$_} } sort @own ),
        "step $step: --help prints every default"
    );
    return;
}

sub check_option {
    my ( $option, $step, $name, $plain ) = @_;
    my %values = map { $_ => $option->{$_} // [] } qw(differ same bad);
    if ( $step != $option->{steps}[0] ) {
        my $list = @{ $values{differ} } ? 'differ' : 'bad';
        my @one  = grep { defined } $values{$list}[0];
        %values = ( differ => [], same => [], bad => [] );
        $values{$list} = \@one if !$option->{check};
    }
    $option->{check}->( $step, $plain, $name ) if $option->{check};
    for my $value ( @{ $values{differ} } ) {
        my $picture = draw( $step, "--$name", $value );
        ok( $picture && $picture ne $plain,
            "step $step: --$name $value changes the picture" );
    }
    for my $value ( @{ $values{same} } ) {
        ok(
            $plain && draw( $step, "--$name", $value ) eq $plain,
            "step $step: --$name $value is the default"
        );
    }
    for my $value ( @{ $values{bad} } ) {
        is_refused(
            $step,
            [ "--$name",     $value ],
            [ qr/--$name\b/, $option->{allowed} ],
            "--$name '$value'"
        );
    }
    return;
}

# Of the options that these steps bring, by name:
#   steps:   which programs have the option
#   differ:  values that draw another picture than the program's defaults do
#   same:    values that draw the same picture
#   bad:     values to refuse; `allowed` is in the line that refuses them
#   check:   what else a good value has to do: called with the step, its
#            default picture, and the name
# A run takes 0.2 s, most of it for loading libraries. So the lists are tried
# in full in the first program that has the option; the others, which share the
# code, try the first value of `differ`, or else of `bad`.
sub test_options {
    my ( $options, @bring ) = @_;
    for my $step ( $bring[0] .. 5 ) {
        check_help( $options, $step, @bring );
        my $plain = draw($step);
        is( png_size($plain), '160x90', "step $step: draws a picture" );
        for my $name ( sort keys %$options ) {
            my $option = $options->{$name};
            check_option( $option, $step, $name, $plain )
              if has_option( $option, $step );
        }
    }
    return;
}

1;
