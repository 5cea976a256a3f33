# Mistakes in the report's arithmetic, for tests/mutants.pl, which says what
# they are made of.
package Mistakes;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(%MISTAKES);

my $WORDS  = 'robustness/report_words';
my $ERRORS = 'tests/oracle/checks/errors.cpp';

our %MISTAKES = (

    # --- the oracle's table of errors ---
    'an error of the wrong sign' => [
        'step5_errors',
        $ERRORS,
        'value.error(pixel.receiver.visibility) : 0',
        '-value.error(pixel.receiver.visibility) : 0'
    ],
    'an RMSE without its root' =>
      [ 'step5_errors', $ERRORS, 'std::sqrt(squares / count)', 'squares / count' ],
    'an RMSE of all pixels, counted or not' => [
        'step5_errors', $ERRORS,
        'std::sqrt(squares / count)',
        'std::sqrt(squares / double(comparison.kinds.size()))'
    ],
    'the 98th percentile' => [
        'step5_errors',                        $ERRORS,
        'long(std::ceil(0.99 * count))', 'long(std::ceil(0.98 * count))'
    ],
    'a share over 2/255' =>
      [ 'step5_errors', $ERRORS, 'error > 1.0 / 255', 'error > 2.0 / 255' ],
    'a mean without signs' => [
        'step5_errors',                                    $ERRORS,
        'sum += double(comparison.error.values[i])', 'sum += error'
    ],
    'silhouettes among the others' => [
        'step5_errors',                                $ERRORS,
        'return pixel.grazing || value.apart ?', 'return value.apart ?'
    ],
    'each link of the chain from light truth' => [
        'step5_chain',                            $ERRORS,
        'link(kinds, images[i - 1].values', 'link(kinds, images[0].values'
    ],

    # --- times ---
    'quartiles that jump from frame to frame' =>
      [ $WORDS, 'tests/report/Measure.pm', '( $place - $index ) *', '0 *' ],
    'a third quartile that is the median' =>
      [ $WORDS, 'tests/report/Measure.pm', '0.75, @times', '0.5, @times' ],
    'a round\'s mean frame for its median' => [
        $WORDS,                     'tests/report/Measure.pm',
        'quantile( 0.5, @$times )', 'eval( join "+", @$times ) / @$times'
    ],
    'the fastest frames are the slowest' => [
        $WORDS,                   'tests/report/Measure.pm',
        'quantile( 0, @$times )', 'quantile( 1, @$times )'
    ],
    'a ratio of the medians of all rounds' => [
        $WORDS,
        'tests/report/Judge.pm',
        "quantile( 0.5,\n        map { \$these->[\$_] / \$those->[\$_] }"
          . ' 0 .. $rounds - 1 )',
        'quantile( 0.5, @$these ) / quantile( 0.5, @$those ) + 0 * $rounds'
    ],

    # --- front, claims, verdicts ---
    'a front by medians' => [
        $WORDS,
        'tests/report/Judge.pm',
        '$this->{total_q3} < $that->{total_q1}',
        '$this->{total_ms} < $that->{total_ms}'
    ],
    'a front that keeps what is slower and as wrong' => [
        $WORDS,                       'tests/report/Judge.pm',
        '<= $that->{footprint_rmse}', '< $that->{footprint_rmse}'
    ],
    'a growth that counts what every picture takes' => [
        $WORDS,           'tests/report/Judge.pm',
        '{ $_ - $rest }', '{ $_ + 0 * $rest }'
    ],
    'edge may be off by 1e-3' => [
        $WORDS,             'tests/report/Judge.pm',
        'pcf_rmse} < 1e-4', 'pcf_rmse} < 1e-3'
    ],
    'bleeding may be off by a tenth' =>
      [ $WORDS, 'tests/report/Judge.pm', '<= 0.02', '<= 0.1' ],
    'a wrong formula of the bleeding' =>
      [ $WORDS, 'tests/report/Judge.pm', '( 4 / 6 )**2', '( 4 / 5 )**2' ],
    'a claim that fails in silence' => [
        'robustness/report', 'tests/report/report.pl',
        "eq 'FAILS' }",      "eq 'fails' }"
    ],
    'a point that is missing in silence' => [
        'robustness/report',                 'tests/report/report.pl',
        'return 3 if @missing || @problems', 'return 3 if @problems'
    ],
    'what cannot be told holds' => [
        $WORDS,                      'tests/report/Judge.pm',
        'return   if $to >= $least', 'return 1 if $to >= $least'
    ],
    'a busy machine\'s slow frames are not looked at' => [
        $WORDS,
        'tests/report/Judge.pm',
        'max(@times) ]',
        'max( @times[ 0 .. $#times - 1 ] ) ]'
    ],
    'a start that waited for others fails' => [
        'robustness/bench',         'tests/report/Startup.pm',
        'return   if $waits > 1.2', 'return 0 if $waits > 1.2'
    ],
    'an exponent by medians alone' => [
        'robustness/bench', 'tests/report/bench.pl',
        '[qw(q3 q1)], [qw(q1 q3)]', '[qw(ms ms)], [qw(ms ms)]'
    ],
    'what one round saves decides' => [
        'robustness/bench', 'tests/report/saved.pl', '0.25, 0.75', '1, 1'
    ],
    'a folder\'s name with a space is two' => [
        'robustness/report', 'tests/report/Measure.pm',
        "matching( \$folder, 'kept/truths.*' )", 'glob("$folder/kept/truths.*")'
    ],
    'a crossing without logarithms' => [
        $WORDS,
        'tests/report/Verdict.pm',
        'log( $from->{factor} ) / log( $from->{factor} / $to->{factor} )',
        '( 1 - $from->{factor} ) / ( $to->{factor} - $from->{factor} )'
    ],
    'a factor the wrong way round' => [
        $WORDS,                         'tests/report/Verdict.pm',
        "( 'PCF', 1 / \$_->{factor} )", "( 'PCF', \$_->{factor} )"
    ],
    'a warning before twice the error' => [
        $WORDS,              'tests/report/Verdict.pm',
        '$best <= 2 * $pcf', '$best <= 1 * $pcf'
    ],
    'a warning where hard shadows are worse' =>
      [ $WORDS, 'tests/report/Verdict.pm', '|| $best <= $hard', '' ],
    'PCF\'s error over VSM\'s' =>
      [ $WORDS, 'tests/report/Verdict.pm', '$vsm / $pcf if', '$pcf / $vsm if' ],
    'from the width below the crossing' => [
        $WORDS, 'tests/report/Verdict.pm',
        '$whole++ while $whole < $width || $whole % 2 == 0',
        '$whole-- while $whole % 2 == 0'
    ],
    'a front drawn through what is as wrong' =>
      [ $WORDS, 'tests/report/Plot.pm', '$error >= $least', '$error > $least' ],
);

1;
