# What each step's exercise empties, and the ways in which it goes wrong.
package Lessons;

use strict;
use warnings;

use Exporter qw(import);

our @EXPORT_OK = qw(%LESSONS);

# By step, in the order in which they are best written:
#   function  its heading in `file`, which is in the step's shaders/
#   empty     what stands there instead of its body, so that it still draws
#   words     what it has to do
#   options   of the run that is looked at first, where mistakes are told apart
#   also      runs in which it has to be right too, because there something is
#             another that the first run would let it hold fixed (a size, a
#             layer, a constant): what is different from the first. In the
#             first function's the whole program is looked at, too
#             (With no options may a technique take the place of the file.)
#   checks    what the oracle is asked about that run, and how those of its
#             lines begin that are about this function
#   shows     [files of the dump, channel]: where a difference is looked for
#   same      files of the dump that are as in the right program: what is drawn
#             before this function's result, and maps, in which every texel is
#             known
#   mistakes  [what went wrong, then pairs: what stands in the right file, what
#             stands there in one that is wrong in this way]
my @VISIBILITY = (
    checks => [ [ 'stage', qr/stage visibility/ ] ],
    shows  => [ 'visibility', 0 ],
    same   => qr/^(?:depth|moments|blurred|position|normal|receiver)\b.*exr$/
);
my @BLUR = (
    checks => [ [ 'stage', qr/stage blur/ ] ],
    shows  => [ 'blurred', 0 ],
    same   => qr/^(?:moments|blurred|position|normal)\b.*exr$/
);

# Maps that are not square and have several layers: a point light's six; and two
# of a view in parts, after the last of which there is only light, and from
# before whose near planes something casts.
my @ROOM   = qw(--scene room --map-size 48x80);
my @SPLITS = qw(--scene fence --splits 2 --map-size 48x80);

# With other constants than step 5 has.
my @OTHER = ( @ROOM, qw(--bleed-reduction 0.5 --min-variance 0.01) );
our %LESSONS = (
    1 => [
        {
            function => 'Receiver map_coordinates'
              . '(vec3 relative_position, vec3 normal, int layer)',
            file  => 'map_coordinates.glsl',
            empty => 'return Receiver(vec2(0.5), 0.0, layer, normal, '
              . 'relative_position);',
            words => 'Where is this position in the map, u and v in [0, 1]? '
              . 'Multiply by the matrix map_from_relative[layer], make the '
              . 'perspective, and let light_depth() say how deep it is.',
            options  => [qw(--scene stage)],
            also     => [
                { options => [@ROOM] },
                { options => [@SPLITS], @VISIBILITY },
            ],
            checks   => [ [ 'matrix', qr/receiver/ ] ],
            shows    => [ 'receiver', 0 ],
            same     => qr/^(?:depth|position|normal)\b.*exr$/,
            mistakes => [
                [
                    'Nothing is divided by w. That is right for a parallel '
                      . 'light, where w is 1; a spot light sees in '
                      . 'perspective, and what is far away is small in its '
                      . 'map.',
                    'map_position.xy / map_position.w' => 'map_position.xy'
                ],
                [
                    'u and v run from -1 to 1, as in clip space. This matrix '
                      . 'already leads to [0, 1]: halve nothing, double '
                      . 'nothing.',
                    'map_position.xy / map_position.w' =>
                      '2.0 * map_position.xy / map_position.w - 1.0'
                ],
                [
                    'v runs downwards. A texture\'s first row is its lowest.',
                    'map_position.xy / map_position.w' =>
                      'vec2(0.0, 1.0) + vec2(1.0, -1.0) * '
                      . 'map_position.xy / map_position.w'
                ],
            ],
        },
        {
            function => 'float visibility(Receiver receiver)',
            file     => 'hard.glsl',
            empty    => 'return 1.0;',
            words    => 'Read the texel that receiver.uv lies in (0 to size '
              . '- 1) from the receiver\'s layer. Lit, 1, is what is not '
              . 'behind the depth that is stored there, else 0. '
              . 'comparison_bias(receiver, 1, vec2(size)) says by how much '
              . 'the receiver is to be taken nearer to the light.',
            options  => [],
            also     => [ { options => [@ROOM] } ],
            @VISIBILITY,
            mistakes => [
                [
                    'What is lit and what is in shadow have changed places: a '
                      . 'receiver that is not behind what the light saw is '
                      . 'lit.',
                    '- bias <= occluder' => '- bias > occluder'
                ],
                [
                    'There is no bias. A texel holds one depth for a whole '
                      . 'patch of the surface, so half of that patch is behind '
                      . 'it: lit surfaces shadow themselves (acne).',
                    'receiver.depth - bias' => 'receiver.depth'
                ],
                [
                    'The bias has the wrong sign: it moves the receiver away '
                      . 'from the light, and all that is lit shadows itself.',
                    'receiver.depth - bias' => 'receiver.depth + bias'
                ],
                [
                    'The neighbouring texel is read: texel i reaches from i to '
                      . 'i + 1, so rounding down finds it, and rounding to the '
                      . 'nearest does not.',
                    'ivec2(receiver.uv * vec2(size))' =>
                      'ivec2(receiver.uv * vec2(size) + 0.5)'
                ],
            ],
        },
    ],
    2 => [
        {
            function => 'float visibility(Receiver receiver)',
            file     => 'pcf.glsl',
            empty    => 'return 1.0;',
            words    => 'Percentage-closer filtering: compare with each of '
              . 'the n x n texels around the one that receiver.uv lies in, n '
              . 'from the constant kernel, and return the share that is '
              . 'lit. occluder_depth(texel, layer) reads a depth, '
              . 'comparison_bias(receiver, n, vec2(size)) is the bias.',
            options  => [],
            also     => [ { options => [ @ROOM, qw(--kernel 3) ] } ],
            @VISIBILITY,
            mistakes => [
                [
                    'The depths are averaged and then compared once. A mean '
                      . 'depth is the depth of nothing: the result is again 0 '
                      . 'or 1, in another place. Compare first, then average.',
                    'lit += receiver.depth - bias <= occluder ? 1.0 : 0.0;' =>
                      'lit += occluder;',
                    'return lit / float(kernel * kernel);' =>
                      'return receiver.depth - bias <= '
                      . 'lit / float(kernel * kernel) ? 1.0 : 0.0;'
                ],
                [
                    'Every tap reads the texel in the middle: n x n times the '
                      . 'same comparison.',
                    'middle + ivec2(x, y)' => 'middle'
                ],
                [
                    'The sum is divided by n, and there are n x n taps.',
                    'float(kernel * kernel)' => 'float(kernel)'
                ],
                [
                    'The last row and column are left out: from -radius to '
                      . 'radius there are 2 radius + 1 texels.',
                    'y <= radius' => 'y < radius',
                    'x <= radius' => 'x < radius'
                ],
                [
                    'What is lit and what is in shadow have changed places.',
                    '- bias <= occluder' => '- bias > occluder'
                ],
                [
                    'The bias is that of a single texel. The furthest of n '
                      . 'taps is n / 2 texels away, where a sloping surface '
                      . 'has another depth: it needs a bias as wide as the '
                      . 'kernel.',
                    'comparison_bias(receiver, kernel,' =>
                      'comparison_bias(receiver, 1,'
                ],
            ],
        },
    ],
    3 => [
        {
            function => 'void main()',
            file     => 'moments.frag',
            empty    => 'moments = vec2(1.0);',
            words    => 'Write the first two moments of the depths in this '
              . 'texel, E[x] and E[x^2]. It holds one depth x, that of '
              . 'map_depth(relative_position, layer).',
            options  => [],
            also     => [ { options => [@SPLITS] } ],
            checks   => [
                [ 'stage', qr/stage moments/ ],
                [ 'rays',  qr/map depths/ ]
            ],
            shows    => [ 'moments', 1 ],
            same     => qr/^(?:moments|position|normal)\b.*exr$/,
            mistakes => [
                [
                    'The second moment is x, not x^2. E[x^2] - E[x]^2 is then '
                      . 'not the variance of anything.',
                    'depth * depth' => 'depth'
                ],
                [
                    'The two channels have changed places: E[x] is in the '
                      . 'first.',
                    'depth, depth * depth' => 'depth * depth, depth'
                ],
                [
                    'The second channel holds the variance, which is 0 of a '
                      . 'single depth. That is the other kind of moments, '
                      . '--moments central; these are E[x] and E[x^2].',
                    'depth * depth' => '0.0'
                ],
            ],
        },
        {
            function => 'float visibility(Receiver receiver)',
            file     => 'mean.glsl',
            empty    => 'return 1.0;',
            words    => 'One comparison, as in step 1, with the mean depth '
              . 'that moments_at(receiver) finds. The bias is '
              . 'comparison_bias(receiver, 1, size), size in texels.',
            options  => [],
            also     => [ { options => [@ROOM] } ],
            @VISIBILITY,
            mistakes => [
                [
                    'The depth is compared with E[x^2]. That is smaller than '
                      . 'E[x]: everything but the map\'s far end is in shadow.',
                    'moments_at(receiver).x' => 'moments_at(receiver).y'
                ],
                [
                    'What is lit and what is in shadow have changed places.',
                    '- bias <= moments_at' => '- bias > moments_at'
                ],
                [
                    'There is no bias: lit surfaces shadow themselves (acne).',
                    'receiver.depth - bias' => 'receiver.depth'
                ],
            ],
        },
    ],
    4 => [
        {
            function => 'void main()',
            file     => 'blur.frag',
            empty    => 'moments = vec2(1.0);',
            words    => 'One pass of a separable blur: the weighted mean of '
              . 'the texels from -radius to radius along axis. weights[0] is '
              . 'that of the first, and all weights add up to 1.',
            options  => [qw(--blur gaussian --radius 4)],
            also     => [ { options => [ @ROOM, qw(--radius 2) ] } ],
            @BLUR,
            mistakes => [
                [
                    'Both passes go along u. The second one has to go along '
                      . 'v, or nothing is blurred upwards: `axis` says which.',
                    'i * axis' => 'i * ivec2(1, 0)'
                ],
                [
                    'Every tap reads the texel in the middle: the mean of n '
                      . 'times the same texel, so nothing is blurred.',
                    'map_texel(middle + i * axis)' => 'map_texel(middle)'
                ],
                [
                    'All weights are the same. That is a box; this filter\'s '
                      . 'weights are in weights[].',
                    'weights[i + radius]' => '1.0 / float(2 * radius + 1)'
                ],
                [
                    'The last tap is missing, so the weights add up to less '
                      . 'than 1 and all depths come nearer to the light.',
                    'i <= radius' => 'i < radius'
                ],
                [
                    'The weights are read from the wrong place: weights[0] '
                      . 'belongs to the tap at -radius.',
                    'weights[i + radius]' => 'weights[abs(i)]'
                ],
            ],
        },
        {
            function => 'void main()',
            file     => 'downsample.frag',
            empty    => 'moments = vec2(1.0);',
            words    => 'A smaller map: the mean of the factor x factor '
              . 'texels that this one covers. map_texel() reads one of them.',
            options  => [qw(--downsample 2)],
            also     => [ { options => [ @ROOM, qw(--downsample 4) ] } ],
            @BLUR,
            mistakes => [
                [
                    'One texel of each group is kept, the others are thrown '
                      . 'away: the map is smaller, but it is not their mean.',
                    'map_texel(corner + ivec2(x, y))' => 'map_texel(corner)'
                ],
                [
                    'The groups overlap: the corner of group i is at i times '
                      . 'factor.',
                    'ivec2(gl_FragCoord.xy) * factor' =>
                      'ivec2(gl_FragCoord.xy)'
                ],
                [
                    'The sum is divided by factor, and there are factor x '
                      . 'factor texels.',
                    'float(factor * factor)' => 'float(factor)'
                ],
            ],
        },
    ],
    5 => [
        {
            function => 'float chebyshev(float mean, float variance, float t)',
            file     => 'chebyshev.glsl',
            empty    => 'return 1.0;',
            words    => 'The largest share of the depths that can be at t or '
              . 'behind it, of all distributions with this mean and variance: '
              . 'the one-tailed inequality.',
            options  => [],
            also     => [ { options => [@OTHER] } ],
            @VISIBILITY,
            mistakes => [
                [
                    'This is the bound of both tails, P(|X - mean| >= s) <= '
                      . 'variance / s^2. We need one tail: of the depths '
                      . 'before the mean it says nothing, and the bound of '
                      . 'Cantelli is smaller.',
                    'variance / (variance + behind * behind)' =>
                      'min(variance / (behind * behind), 1.0)'
                ],
                [
                    'This is the bound of both tails, P(|X - mean| >= s) <= '
                      . 'variance / s^2, and on both sides of the mean. We '
                      . 'need one tail, of what is behind it; what is nearer '
                      . 'to the light than the mean is lit.',
                    'variance / (variance + behind * behind)' =>
                      'min(variance / (behind * behind), 1.0)',
                    'behind > 0.0 ? p_max : 1.0' => 'p_max'
                ],
                [
                    'The inequality holds where t is behind the mean. What is '
                      . 'nearer to the light than the mean is lit; here it '
                      . 'gets darker again, the nearer it is.',
                    'behind > 0.0 ? p_max : 1.0' => 'p_max'
                ],
                [
                    'The two sides of the mean have changed places: the bound '
                      . 'is for t behind it.',
                    'behind > 0.0' => 'behind <= 0.0'
                ],
                [
                    'The variance is squared once too often: it is a square '
                      . 'of a depth already, as (t - mean)^2 is.',
                    'variance / (variance + behind * behind)' =>
                      'variance * variance / '
                      . '(variance * variance + behind * behind)'
                ],
                [
                    'The distance from the mean is not squared: variance and '
                      . '(t - mean)^2 are both squares of depths.',
                    'behind * behind' => 'behind'
                ],
                [
                    'This is the share that is in shadow, 1 - p_max.',
                    'variance / (variance + behind * behind)' =>
                      'behind * behind / (variance + behind * behind)'
                ],
            ],
        },
        {
            function => 'float reduce_bleeding(float p_max)',
            file     => 'reduction_linear.glsl',
            empty    => 'return p_max;',
            words    => 'Cut off what is below bleed_reduction and stretch '
              . 'the rest to [0, 1].',
            options  => [qw(--bleed-reduction 0.3)],
            also     => [ { options => [@OTHER] } ],
            @VISIBILITY,
            mistakes => [
                [
                    'The lower end is cut off, but the rest is not stretched: '
                      . 'what is fully lit is now darker. p_max = 1 has to '
                      . 'stay 1.',
                    '(p_max - bleed_reduction) / (1.0 - bleed_reduction)' =>
                      'p_max - bleed_reduction'
                ],
                [
                    'What is below is cut off, but what is above is left as '
                      . 'it was: the light jumps from 0 to A, an edge in the '
                      . 'middle of the penumbra.',
                    'clamp((p_max - bleed_reduction) / '
                      . "(1.0 - bleed_reduction), 0.0,\n                 1.0)"
                      => '(p_max < bleed_reduction ? 0.0 : p_max)'
                ],
                [
                    'The rest is stretched by A instead of 1 - A: with p_max '
                      . '= 1 it has to be 1.',
                    '(1.0 - bleed_reduction)' => 'bleed_reduction'
                ],
                [
                    'Below A the light is negative. Cut it off at 0.',
                    'bleed_reduction), 0.0,' => 'bleed_reduction), -1.0,'
                ],
            ],
        },
        {
            function => 'float visibility(Receiver receiver)',
            file     => 'visibility.glsl',
            empty    => 'return 1.0;',
            words    => 'Put it together. moments_at(receiver) is M1 and M2. '
              . 'Find their variance; it is at least min_variance. Then add '
              . 'what rounding can have taken: guard_mean.x times M1 and '
              . 'guard_mean.y to the mean, guard_variance.x times M2 and '
              . 'guard_variance.y to the variance. Return their chebyshev() '
              . 'at the receiver\'s depth, with reduce_bleeding() applied.',
            options  => [qw(--bleed-reduction 0.18)],
            also     => [ { options => [@OTHER] } ],
            @VISIBILITY,
            mistakes => [
                [
                    'Light bleeding is not reduced.',
                    'reduce_bleeding(chebyshev(mean, variance, '
                      . 'receiver.depth))' =>
                      'chebyshev(mean, variance, receiver.depth)'
                ],
                [
                    'M2 is taken for the variance. It is E[x^2]: what remains '
                      . 'without E[x]^2 is the variance.',
                    'max(M2 - M1 * M1' => 'max(M2'
                ],
                [
                    'M1 and M2 have changed places: E[x] is in the first '
                      . 'channel.',
                    'M1 = moments.x' => 'M1 = moments.y',
                    'M2 = moments.y' => 'M2 = moments.x'
                ],
                [
                    'The variance is 0, and only what is added for rounding '
                      . 'is left. It is M2 less the square of M1, or '
                      . 'min_variance: the larger of both (max).',
                    'max(' => 'min('
                ],
                [
                    'Nothing is added for what rounding can have taken. Where '
                      . 'all is flat and lit, the variance is only rounding, '
                      . 'and lit surfaces get dark specks.',
                    'M1 + (guard_mean.x * M1 + guard_mean.y)'  => 'M1',
                    'guard_variance.x * M2 + guard_variance.y' => '0.0'
                ],
            ],
        },
    ],
);

1;
