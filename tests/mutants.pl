#!/usr/bin/perl
# Plants one mistake at a time and demands that a test fails: in a shader; in a
# C file, and then builds the programs again in a copy; or in the arithmetic of
# the oracle and the report (report/Mistakes.pm). The tests compare with
# formulas, closed forms and ray casting: none of them knows the committed
# pictures. usage: mutants.pl [NAME...]
use strict;
use warnings;
use Cwd qw(abs_path);
use File::Basename qw(dirname);
use File::Path qw(make_path);
use File::Temp qw(tempdir);
use FindBin;
use lib "$FindBin::Bin/report", "$FindBin::Bin/lib";
use Mistakes qw(%MISTAKES);
use Plant    qw(planted);

# name => [test that must fail, file, what stands there, the mistake, and where
# one file is not enough another three of these]
my %mutants = (
    %MISTAKES,
    'every tap reads the same texel' => [
        'step2', 'step2_pcf/shaders/pcf.glsl',
        'middle + ivec2(x, y)',
        'middle + 0 * ivec2(x, y)'
    ],
    'a disc that is not turned' => [
        'step2', 'step2_pcf/techniques/poisson/poisson_disc.glsl',
        'poisson_turns[4 * pixel.y + pixel.x]', 'poisson_turns[0]'
    ],
    'a disc of twice the radius' => [
        'step2', 'step2_pcf/techniques/poisson/pcf_poisson.glsl',
        '0.5 * float(width)', 'float(width)'
    ],
    'all taps of the disc at one place' => [
        'step2', 'step2_pcf/techniques/poisson/pcf_poisson.glsl',
        'poisson_tap(i)', 'poisson_tap(0)'
    ],
    'a comparison the wrong way round' => [
        'step1', 'step1_shadowmap/shaders/hard.glsl',
        '- bias <= occluder', '- bias >= occluder'
    ],
    'a bias of the wrong sign' => [
        'step1', 'step1_shadowmap/shaders/hard.glsl',
        'depth - bias', 'depth + bias'
    ],
    'half a texel off' => [
        'step1', 'step1_shadowmap/shaders/hard.glsl',
        'ivec2(receiver.uv * vec2(size))',
        'ivec2(receiver.uv * vec2(size) + 0.5)'
    ],
    'the picture upside down' => [
        'step1', 'step1_shadowmap/shaders/scene.vert',
        'clip_from_relative * vec4(relative_position, 1.0);',
        'clip_from_relative * vec4(relative_position, 1.0); '
          . 'gl_Position.y = -gl_Position.y;'
    ],
    'the map upside down' => [
        'step1', 'step1_shadowmap/shaders/map.vert',
        'map_position.w, map_position.w);',
        'map_position.w, map_position.w) * vec4(1, -1, 1, 1);'
    ],
    'visible although it faces away' => [
        'step1', 'step1_shadowmap/shaders/scene.frag',
        'facing > 0.0', 'true'
    ],
    'half the slope bias' => [
        'step2', 'step1_shadowmap/shaders/bias.glsl',
        '0.5 * float(kernel + 1)', '0.25 * float(kernel + 1)'
    ],
    'a slope bias for one texel' => [
        'all_bias', 'step1_shadowmap/shaders/bias.glsl',
        '0.5 * float(kernel + 1)', '1.0'
    ],
    'no constant bias' => [
        'all_bias', 'step1_shadowmap/shaders/bias.glsl',
        'return bias + slope_bias', 'return slope_bias'
    ],
    'one tap row forgotten' => [
        'step2', 'step2_pcf/shaders/pcf.glsl', 'y <= radius', 'y < radius'
    ],
    'a width by the shorter axis' => [
        'step2_pcf', 'step2_pcf/techniques/adaptive/width_adaptive.glsl',
        '.longer', '.shorter'
    ],
    'a width that is not clamped' => [
        'step2_pcf', 'step2_pcf/techniques/adaptive/width_adaptive.glsl',
        'min(2 * radius + 1, kernel)', '2 * radius + 1'
    ],
    'weights of the rim swapped' => [
        'step2_pcf', 'step2_pcf/techniques/bilinear/pcf_bilinear.glsl',
        'i == width ? part : 1.0', 'i == width ? 1.0 - part : 1.0'
    ],
    'bilinear taps half a texel off' => [
        'step2_pcf', 'step2_pcf/techniques/bilinear/pcf_bilinear.glsl',
        'vec2(size) - 0.5', 'vec2(size)'
    ],
    'both moments scaled' => [
        'step3', 'step3_moments/shaders/moments.frag',
        'vec2(depth, depth * depth)',
        '0.5 * vec2(depth, depth * depth)'
    ],
    'M2 is not the square' => [
        'step3', 'step3_moments/shaders/moments.frag',
        'depth * depth', 'depth'
    ],
    'compared with M2' =>
      [ 'step3', 'step3_moments/shaders/mean.glsl', ').x', ').y' ],
    'only one axis blurred' => [
        'step4', 'step4_blur/shaders/blur.frag',
        'i * axis', 'i * ivec2(axis.x, 0)'
    ],
    'a kernel that is not normalised' => [
        'step4', 'step4_blur/shaders/blur.frag',
        'weights[i + radius]', '1.01 * weights[i + radius]'
    ],
    'one texel for a group' => [
        'step4', 'step4_blur/shaders/downsample.frag',
        'corner + ivec2(x, y)', 'corner'
    ],
    'half a texel off while downsampling' => [
        'step4', 'step4_blur/shaders/downsample.frag',
        '* factor;', '* factor + 1;'
    ],
    'M2 from the blurred mean' => [
        'step4', 'step4_blur/shaders/blur.frag',
        "i * axis);\n    }",
        "i * axis);\n    }\n    moments.y = moments.x * moments.x;"
    ],
    'the blur returns its input' => [
        'step4', 'step4_blur/shaders/blur.frag',
        'map_texel(middle + i * axis)', 'map_texel(middle)'
    ],
    'one texel out of range' => [
        'step3',
        'step3_moments/shaders/moments.frag',
        'vec2(depth, depth * depth);',
        "vec2(depth, depth * depth);\n"
          . '    if (ivec2(gl_FragCoord.xy) == ivec2(99)) moments *= 100.0;'
    ],
    'one texel that is no number' => [
        'step3',
        'step3_moments/shaders/moments.frag',
        'vec2(depth, depth * depth);',
        "vec2(depth, depth * depth);\n"
          . '    if (ivec2(gl_FragCoord.xy) == ivec2(99))'
          . ' moments = vec2(uintBitsToFloat(0x7fc00000u));'
    ],
    'the map\'s edge goes on outside' => [
        'step4',
        'step1_shadowmap/base/gl/gl.c',
        '(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER',
        '(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE'
    ],
    'the mean in place of the variance' => [
        'step5', 'step5_chebyshev/shaders/chebyshev.glsl',
        'variance / (variance + behind', 'mean / (mean + behind'
    ],
    'a central merge about no depth of its own' => [
        'stability/stability', 'step3_moments/techniques/central/merge_central.glsl',
        'return Merge(heaviest.x, 0.0, 0.0);', 'return Merge(0.0, 0.0, 0.0);'
    ],
    'depths outside the range' => [
        'stability/stability', 'step1_shadowmap/shaders/light_depth.glsl',
        'clamp(light_depth(relative_position, layer), 0.0, 1.0)',
        'light_depth(relative_position, layer)'
    ],
    'a lookup whose variance forgets the distance' => [
        'stability/stability', 'step3_moments/techniques/central/merge_central.glsl',
        'part * rest * apart * apart', '0.0'
    ],
    'weights of 2 x 2 swapped' => [
        'all_truths', 'step2_pcf/techniques/bilinear/pcf_bilinear.glsl',
        'return 1.0 - part;', 'return part;'
    ],
    'a rim that is not weighted' => [
        'all_truths', 'step2_pcf/techniques/bilinear/pcf_bilinear.glsl',
        'i == width ? part : 1.0', '1.0'
    ],
    'the wrong row of the kernel' => [
        'all_truths', 'step4_blur/shaders/blur.frag',
        'weights[i + radius]', 'weights[abs(i)]'
    ],
    'the variance bias taken away' => [
        'step5', 'step5_chebyshev/techniques/variance_bias/bias.glsl',
        'variance + variance_bias', 'variance - variance_bias'
    ],
    'a variance bias without a limit' => [
        'step5', 'step5_chebyshev/techniques/variance_bias/bias.glsl',
        'min(variance + variance_bias, 1.0)', 'variance + variance_bias'
    ],
    'a smooth reduction without rounded ends' => [
        'step5', 'step5_chebyshev/techniques/smooth/reduction_smooth.glsl',
        'smoothstep(bleed_reduction, 1.0, p_max)',
        'clamp((p_max - bleed_reduction) / (1.0 - bleed_reduction), 0.0, 1.0)'
    ],
    'a smooth reduction from 0' => [
        'step5', 'step5_chebyshev/techniques/smooth/reduction_smooth.glsl',
        'smoothstep(bleed_reduction', 'smoothstep(0.0'
    ],
    'what is outside the map is near' => [
        'step4', 'step1_shadowmap/base/picture/frame.c',
        'single.filter = GL_NEAREST;',
        'single = (Sampling){GL_NEAREST, {0, 0, 0, 0}};'
    ],
    'a kernel compiled wider than was asked for' => [
        'step2', 'step2_pcf/pcf.c',
        '"const int kernel = %d;"', '"const int kernel = %d + 2;"'
    ],
    'the blur reads between texels' => [
        'step4', 'step1_shadowmap/base/picture/frame.c',
        'single.filter = GL_NEAREST', 'single.filter = GL_LINEAR'
    ],
    'central moments that the texture unit averages' => [
        'all_central', 'step3_moments/techniques/central/central.c',
        '{GL_NEAREST', '{GL_LINEAR'
    ],
    'a copy without shaders takes those of the tree around it' => [
        'robustness/moved', 'step1_shadowmap/base/files/file.c',
        '"%s/step1_shadowmap"', '"%s/step1_shadowmap/shaders"'
    ],
    'a link to no shader is not there' => [
        'robustness/moved', 'step1_shadowmap/base/gl/shader_file.c',
        'lstat(path, &status) == 0', 'stat(path, &status) == 0'
    ],
    "an error in the tree's file, which was not read" => [
        'robustness/bad_input', 'step1_shadowmap/base/gl/gl_program.c',
        'shader_find(program->shaders->directory', 'shader_find(NULL'
    ],
    'a driver that crashes without a word' => [
        'robustness/bad_input', 'step1_shadowmap/base/safety/crash.c',
        'steered || steers(*variable)', 'steered && steers(*variable)'
    ],
    'a printed program without its constants' => [
        'robustness/printed', 'step1_shadowmap/base/measure/print_shader.c',
        "shader_version(stage_from(name)),\n                   program->constants",
        'shader_version(stage_from(name)), ""'
    ],
    'a printed program with the lesson in place of a technique' => [
        'robustness/printed', 'step1_shadowmap/base/gl/gl_program.c',
        'gl_find_files(shaders, files, program->files);',
        'gl_find_files(&(Shaders){0}, files, program->files);'
    ],

    # Texts are judged in a copy of the tree, as what a Makefile says is.
    'a lesson that knows a technique' => [
        'robustness/lesson_alone', 'step3_moments/Makefile',
        '# What', '# What',
        'step3_moments/moments.c',
        'void moments_draw(', "bool moments_central;\n\nvoid moments_draw("
    ],
    'a lesson that knows what is left out' => [
        'robustness/lesson_alone', 'step3_moments/Makefile',
        '# What', '# What',
        'step3_moments/main.c',
        'run_begin(&state.run);', 'run_begin(&state.run), leave_out_print();'
    ],
    "a technique's shader by its path" => [
        'robustness/lesson_alone', 'step5_chebyshev/Makefile',
        '# What', '# What',
        'step5_chebyshev/main.c',
        'step5_chebyshev/shaders/reduction_linear',
        'step5_chebyshev/techniques/smooth/reduction_smooth'
    ],
    'a hook in a lesson for techniques alone' => [
        'robustness/lesson_alone', 'step4_blur/Makefile',
        '# What', '# What',
        'step4_blur/blur.h',
        'void blur_apply(', "void blur_hook(void);\n\nvoid blur_apply("
    ],
    'a member for techniques alone' => [
        'robustness/lesson_alone', 'step4_blur/Makefile',
        '# What', '# What',
        'step4_blur/blur.h',
        'Program *downsample;', "Program *downsample;\n    bool (*asked)(void);"
    ],
    'an argument for techniques alone' => [
        'robustness/lesson_alone', 'step1_shadowmap/Makefile',
        '# What', '# What',
        'step1_shadowmap/shaders/bias.glsl',
        'receiver.layer))', 'receiver.layer, 0.02))',
        'step5_chebyshev/techniques/soft/penumbra.glsl',
        'receiver.layer)', 'receiver.layer, 0.1)'
    ],
    'a shader that does not say all that it needs' => [
        'robustness/needs', 'step1_shadowmap/Makefile',
        '# What', '# What',
        'step1_shadowmap/shaders/bias.glsl',
        'Receiver, depth_slope', 'Receiver'
    ],
    'a shader that says it needs more than it does' => [
        'robustness/needs', 'step1_shadowmap/Makefile',
        '# What', '# What',
        'step1_shadowmap/shaders/bias.glsl',
        'Receiver, depth_slope', 'Receiver, footprint, depth_slope'
    ],
    'a shader that does not offer what it says' => [
        'robustness/needs', 'step1_shadowmap/Makefile',
        '# What', '# What',
        'step1_shadowmap/shaders/bias.glsl',
        'offers: comparison_bias', 'offers: comparison_bias, biased'
    ],
    'a constant that comes from elsewhere' => [
        'robustness/needs', 'step4_blur/Makefile',
        '# What', '# What',
        'step4_blur/shaders/blur.frag', 'from blur.c', 'from pcf.c'
    ],
    'a shader without a word on what it does' => [
        'robustness/needs', 'step4_blur/Makefile',
        '# What', '# What',
        'step4_blur/shaders/downsample.frag',
        "// A smaller map: the mean of factor x factor texels. The moments of a group of\n// texels are the means of their moments.\n", ''
    ],
    'a lesson that grew' => [
        'robustness/lesson', 'step2_pcf/Makefile',
        '# What', '# What',
        'step2_pcf/pcf.c', 'PcfSettings pcf_s', "\n" x 50 . 'PcfSettings pcf_s'
    ],
    'a main.c that grew' => [
        'robustness/lesson', 'step4_blur/Makefile',
        '# What', '# What',
        'step4_blur/main.c', 'int main', "\n" x 45 . 'int main'
    ],
    "a file of a lesson that is not in its list" => [
        'robustness/lesson', 'step3_moments/Makefile',
        "    step3_moments/shaders/mean.glsl \\\n", ''
    ],
    'a file of a lesson that no program compiles' => [
        'robustness/lesson', 'step3_moments/moments.c',
        'shaders/show_mean.glsl', 'shaders/show_variance.glsl'
    ],
    "a technique's shader in a default picture" => [
        'robustness/lesson', 'step5_chebyshev/main.c',
        'step5_chebyshev/shaders/reduction_linear',
        'step5_chebyshev/techniques/smooth/reduction_smooth'
    ],
    'what is printed is lost' => [
        'robustness/printed', 'step1_shadowmap/base/system/die.c',
        'fflush(stdout) != 0 || ferror(stdout)',
        'fflush(stdout) != 0 && feof(stdout)'
    ],
    'a display in the place of stdout' => [
        'robustness/window', 'step1_shadowmap/base/safety/prepare.c',
        'F_GETFD) == -1', 'F_GETFD) == -2'
    ],
    'times of a map that is kept, without a word' => [
        'robustness/printed', 'step1_shadowmap/base/measure/bench.c',
        'touched[0].texels == 0', 'touched[0].texels == 1'
    ],
    'a picture that nobody asked for' => [
        'robustness/written',          'step1_shadowmap/base/picture/settings.c',
        'other && !settings->window', 'other && settings->window'
    ],
    'a file in the place of a link' => [
        'robustness/written', 'step1_shadowmap/base/safety/whole_file.c',
        'replace(target, &old', 'replace(path, &old'
    ],
    'permissions that are lost' => [
        'robustness/written', 'step1_shadowmap/base/safety/whole_file.c',
        'old->st_mode & 07777', '0600'
    ],
    'a name that leaves no room for a longer one' => [
        'robustness/written', 'step1_shadowmap/base/safety/whole_file.c',
        'errno == ENAMETOOLONG', 'errno == ENOSYS'
    ],
    'a file of the part that another program left' => [
        'robustness/killed',     'step1_shadowmap/base/safety/whole_file.c',
        'ftruncate(file, 0) != 0', 'lseek(file, 0, SEEK_END) < 0'
    ],
    'a picture that is stretched' => [
        'robustness/window', 'step1_shadowmap/base/run/window.c',
        'fmin((double)inside', 'fmax((double)inside'
    ],
    'keys of small letters only' => [
        'robustness/window', 'step1_shadowmap/base/gl/context.c',
        '(char)tolower(letter)', '(char)letter'
    ],
    'keys of Latin letters only' => [
        'robustness/window', 'step1_shadowmap/base/gl/context.c',
        '(unsigned char)*name >= 128', '(unsigned char)*name > 255'
    ],
    'a PNG upside down' => [
        'all_files', 'step1_shadowmap/base/files/image.c',
        '-width * channels', 'width * channels'
    ],
    'a PNG of linear values' => [
        'all_files', 'step1_shadowmap/base/files/image.c',
        '(255 * encoded', '(255 * value'
    ],
    'an EXR upside down' => [
        'all_files', 'step1_shadowmap/base/files/image_exr.cpp',
        'row * std::size_t(y);', 'row * std::size_t(height - 1 - y);'
    ],
    'far depth that varies' => [
        'all_central', 'step3_moments/techniques/central/central.c',
        '{1, 0, 1, 1}', '{1, 1, 1, 1}'
    ],
    'no least variance in the lesson' => [
        'step5', 'step5_chebyshev/shaders/visibility.glsl',
        'max(M2 - M1 * M1, min_variance)', 'M2 - M1 * M1'
    ],
    'no least variance' => [
        'step5_soft', 'step5_chebyshev/techniques/guard/guard_constant.glsl',
        'max(variance_of(moments), min_variance)', 'variance_of(moments)'
    ],
    'lit is not told from shadowed' => [
        'step5', 'step5_chebyshev/shaders/chebyshev.glsl',
        'behind > 0.0 ? p_max : 1.0', 'p_max'
    ],
    'the bound turned round' => [
        'step5', 'step5_chebyshev/shaders/chebyshev.glsl',
        'behind > 0.0 ? p_max : 1.0',
        'behind < 0.0 ? p_max : 1.0'
    ],
    'the last split for all' => [
        'all_splits', 'step1_shadowmap/techniques/splits/layer_split.glsl',
        'depth > split_range[layer].y', 'true'
    ],
    'a hand-over to the wrong side' => [
        'all_splits', 'step1_shadowmap/techniques/splits/layer_split.glsl',
        'smoothstep(split_range[layer].x, split_range[layer].y',
        'smoothstep(split_range[layer].y, split_range[layer].x'
    ],
    'a hand-over that is not made' => [
        'all_splits', 'step1_shadowmap/techniques/splits/scene_splits.frag',
        'mix(lit, after, share)', 'lit'
    ],
    'handed over to itself' => [
        'all_splits', 'step1_shadowmap/techniques/splits/scene_splits.frag',
        'min(layer + 1, layers - 1)', 'layer'
    ],
    'before the near plane is behind' => [
        'all_splits', 'step1_shadowmap/shaders/light_depth.glsl',
        'clamp(light_depth(relative_position, layer), 0.0, 1.0)',
        'fract(light_depth(relative_position, layer))'
    ],
    'the opposite view of a point light' => [
        'all_lights', 'step1_shadowmap/techniques/lights/layer_face.glsl',
        'from_light[axis] < 0.0', 'from_light[axis] > 0.0'
    ],
    'an axis as good as the largest' => [
        'all_lights', 'step1_shadowmap/techniques/lights/layer_face.glsl',
        'size.y >= size.z ? 1 : 2', '1'
    ],
    'no division by w' => [
        'all_lights', 'step1_shadowmap/shaders/map_coordinates.glsl',
        'map_position.xy / map_position.w', 'map_position.xy'
    ],
    'the depth along an axis' => [
        'all_lights', 'step1_shadowmap/techniques/lights/distance_depth.glsl',
        'length(towards_light(relative_position))',
        'abs(towards_light(relative_position).y)'
    ],
    'central moments merged about 0' => [
        'all_central', 'step3_moments/techniques/central/merge_central.glsl',
        'Merge(heaviest.x, 0.0, 0.0)', 'Merge(0.0, 0.0, 0.0)'
    ],
    'merged about a tap at the rim' => [
        'all_central', 'step4_blur/techniques/shared/blur_central.frag',
        'map_texel(middle))', 'map_texel(middle - radius * axis))'
    ],
    'a mean that is not moved back' => [
        'all_central', 'step3_moments/techniques/central/merge_central.glsl',
        'merge.square / weights - shift * shift', 'merge.square / weights'
    ],
    'variances averaged like means' => [
        'all_central', 'step3_moments/techniques/central/merge_central.glsl',
        'part * rest * apart * apart', '0.0'
    ],
    'a slope of central moments without a limit' => [
        'all_central', 'step3_moments/techniques/central/merge_central.glsl',
        'min(variance, depth - depth * depth)', 'variance'
    ],
    '16 bits cut off' => [
        'all_central', 'step3_moments/techniques/central/store_half.glsl',
        'bits + 0xfffu + (bits >> 13 & 1u)', 'bits'
    ],
    'small halves cut off' => [
        'all_central', 'step3_moments/techniques/central/store_half.glsl',
        'roundEven(', 'floor('
    ],
    'outside a central map boxes find depths that vary' => [
        'step4_boxes', 'step3_moments/techniques/central/merge_central.glsl',
        'vec2(1.0, 0.0)', 'vec2(1.0, 1.0)'
    ],
    'a tenth of what rounds the mean' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        'chain_mean.x * mean', '0.1 * chain_mean.x * mean'
    ],
    'ten times what rounds the mean' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        'chain_mean.x * mean', '10.0 * chain_mean.x * mean'
    ],
    'a tenth of the spread' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        'chain_spread * deviation', '0.1 * chain_spread * deviation'
    ],
    'ten times the spread' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        'chain_spread * deviation', '10.0 * chain_spread * deviation'
    ],
    'a tenth of what rounds the deviation' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        'chain_variance.x * size', '0.1 * chain_variance.x * size'
    ],
    'ten times what rounds the deviation' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        'chain_variance.x * size', '10.0 * chain_variance.x * size'
    ],
    'a tenth of the noise' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        '64.0 / 16777216.0', '6.4 / 16777216.0'
    ],
    'ten times the noise' => [
        'all_central', 'step5_chebyshev/techniques/guard/guard_central.glsl',
        '64.0 / 16777216.0', '640.0 / 16777216.0'
    ],
    'a tenth of what raw moments lose' => [
        'all_central', 'step5_chebyshev/shaders/visibility.glsl',
        'guard_variance.x * M2', '0.1 * guard_variance.x * M2'
    ],
    'ten times what raw moments lose' => [
        'all_central', 'step5_chebyshev/shaders/visibility.glsl',
        'guard_variance.x * M2', '10.0 * guard_variance.x * M2'
    ],
    'raw moments in 16 bits' => [
        'robustness/options_chebyshev', 'step5_chebyshev/techniques/guard/guard_settings.c',
        '} else if (is_half(frame)) {', '} else if (false) {'
    ],
    'raw moments in mip-maps' => [
        'robustness/options_chebyshev', 'step5_chebyshev/techniques/guard/guard_settings.c',
        '} else if (options_on(options, "mips")) {', '} else if (false) {'
    ],
    'a closed form of one axis' => [
        'step5', 'step5_chebyshev/chebyshev.c', '2 * along', 'along'
    ],
    'a closed form without downsampling' => [
        'step5', 'step5_chebyshev/chebyshev.c', ' + group', ''
    ],
    'a variance that loses as little as the mean' => [
        'step5', 'step5_chebyshev/chebyshev.c', '3 * part', 'part'
    ],
    'projected in the map, not divided' => [
        'step3_moments', 'step3_moments/techniques/projected/projected_depth.glsl',
        ' / dot(map_row(layer, 3), position)', ''
    ],
    'a projected slope without w' => [
        'step3_moments', 'step3_moments/techniques/projected/projected_depth.glsl',
        ' - t * along.xyz', ''
    ],
    'a slope of u only' => [
        'step3_moments', 'step3_moments/techniques/slope/slope_plane.glsl',
        'dot(per_texel, per_texel)', 'per_texel.x * per_texel.x'
    ],
    'the variance of a uniform texel' => [
        'step3_moments', 'step3_moments/techniques/slope/slope_plane.glsl',
        '0.25', '(1.0 / 12.0)'
    ],
    'a normal from one edge and a corner' => [
        'step3_moments', 'step3_moments/techniques/slope/triangle_plane.geom',
        'corner_position[2].xyz - first', 'corner_position[2].xyz'
    ],
    'four times the variance by derivatives' => [
        'step3_moments', 'step3_moments/techniques/slope/slope_derivatives.glsl',
        '0.25 * dot', 'dot'
    ],
    'a derivative for both axes' => [
        'step3_moments', 'step3_moments/techniques/slope/slope_derivatives.glsl',
        'dFdy(light', 'dFdx(light'
    ],
    'a slope added without a limit' => [
        'step3_moments', 'step3_moments/techniques/shared/merge_raw.glsl',
        'min(depth * depth + variance, depth)', 'depth * depth + variance'
    ],
    'one sample for all' => [
        'step3_msaa', 'step3_moments/techniques/msaa/resolve.frag',
        'texelFetch(samples, texel, i)', 'texelFetch(samples, texel, 0)'
    ],
    'a sample left out' => [
        'step3_msaa', 'step3_moments/techniques/msaa/resolve.frag',
        'i < count', 'i < count - 1'
    ],
    'samples that do not vary' => [
        'step3_msaa',
        'step3_moments/techniques/msaa/resolve.frag',
        'stored(merge_end(merge, float(count)));',
        "stored(merge_end(merge, float(count)));\n"
          . '    moments.y = moments.x * moments.x;'
    ],
    'a depth beside its triangle' => [
        'step3_msaa',
        'step3_moments/techniques/msaa/centroid_out.glsl',
        'centroid out', 'out',
        'step3_moments/techniques/msaa/centroid_in.glsl',
        'centroid in', 'in'
    ],
    'the w of another place' => [
        'step3_msaa', 'step3_moments/techniques/msaa/centroid_in.glsl',
        'covered_position.xyz / covered_position.w', 'covered_position.xyz'
    ],
    'light outside the cone' => [
        'all_lights', 'step1_shadowmap/techniques/lights/scene_lights.frag',
        'facing > 0.0 && spread < cone_spreads.x', 'facing > 0.0'
    ],
    'light that falls with the distance only' => [
        'all_lights', 'step1_shadowmap/techniques/lights/scene_lights.frag',
        'part * part', 'part'
    ],
    'a cone without a soft edge' => [
        'all_lights', 'step1_shadowmap/techniques/lights/scene_lights.frag',
        '* cone * cone', ''
    ],
    'a slope as if u were linear' => [
        'all_lights', 'step1_shadowmap/shaders/depth_slope.glsl',
        '- quotient * rows[3].xyz', ''
    ],
    'a distance that is not squared' => [
        'step5', 'step5_chebyshev/shaders/chebyshev.glsl',
        'behind * behind', 'abs(behind)'
    ],
    'a reduction that cuts and does not stretch' => [
        'step5', 'step5_chebyshev/shaders/reduction_linear.glsl',
        ' / (1.0 - bleed_reduction)', ''
    ],
    'reduction without the clamp' => [
        'step5',
        'step5_chebyshev/shaders/reduction_linear.glsl',
        "clamp((p_max - bleed_reduction) / (1.0 - bleed_reduction), 0.0,\n"
          . '                 1.0)',
        '(p_max - bleed_reduction) / (1.0 - bleed_reduction)'
    ],
    'the normal of the other side' => [
        'step5_deferred', 'step5_chebyshev/techniques/deferred/gbuffer.frag',
        'stored_normal = viewer_normal()', 'stored_normal = -viewer_normal()'
    ],
    'the next pixel\'s position' => [
        'step5_deferred', 'step5_chebyshev/techniques/deferred/surface_stored.glsl',
        'stored_position, ivec2(gl_FragCoord.xy)',
        'stored_position, ivec2(gl_FragCoord.xy) + ivec2(1, 0)'
    ],
    'derivatives taken of stored positions' => [
        'step5_deferred', 'step5_chebyshev/techniques/deferred/steps_stored.glsl',
        'texelFetch(stored_right, ivec2(gl_FragCoord.xy), 0).xyz',
        'dFdx(relative_position)'
    ],
    'a box that shrinks when the camera is near' => [
        'step5_sat_width', 'step5_chebyshev/techniques/sat_width/lookup_sat_adaptive.glsl',
        'inversesqrt(', 'sqrt('
    ],
    'a box of the pixel\'s area' => [
        'step5_sat_width', 'step5_chebyshev/techniques/sat_width/lookup_sat_adaptive.glsl',
        'inversesqrt(max(texels, 1e-12))', '1.0 / max(texels, 1e-12)'
    ],
    'a box without a limit' => [
        'step5_sat_width', 'step5_chebyshev/techniques/sat_width/lookup_sat_adaptive.glsl',
        '1.0, box_width)', '0.01, 64.0)'
    ],
    'u and v swapped for the sampler' => [
        'step4_sampler', 'step4_blur/techniques/mips/lookup_hardware.glsl',
        'vec3(receiver.uv,', 'vec3(receiver.uv.yx,'
    ],
    'derivatives in texels for the sampler' => [
        'step4_sampler', 'step4_blur/techniques/mips/lookup_hardware.glsl',
        'steps.xy, steps.zw', '9.0 * steps.xy, 9.0 * steps.zw'
    ],
    'levels made with a box' => [
        'step4_prefilters', 'step4_blur/techniques/mips/mips.frag',
        'vec4(1.0, 3.0, 3.0, 1.0) / 8.0',
        'vec4(0.0, 4.0, 4.0, 0.0) / 8.0'
    ],
    'levels half a texel off' => [
        'step4_prefilters', 'step4_blur/techniques/mips/mips.frag',
        'ivec2(gl_FragCoord.xy) - 1', 'ivec2(gl_FragCoord.xy)'
    ],
    'one level too coarse' => [
        'step4_prefilters', 'step4_blur/techniques/mips/lookup_trilinear.glsl',
        'log2(max(pixel_ellipse(receiver, size).longer, 1.0))',
        'log2(max(2.0 * pixel_ellipse(receiver, size).longer, 1.0))'
    ],
    'levels not blended' => [
        'step4_prefilters', 'step4_blur/techniques/mips/mip_levels.glsl',
        'wanted - fine)', '0.0)'
    ],
    'taps that were turned and then forgotten' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/lookup_soft.glsl',
        'moments_at_level(uv,', 'moments_at_level(receiver.uv,'
    ],
    'a disc whose points do not turn' => [
        'step5_soft', 'step2_pcf/techniques/poisson/poisson_disc.glsl',
        'poisson_turns[4 * pixel.y + pixel.x]', 'poisson_turns[0]'
    ],
    'all taps at the finest level' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/lookup_soft.glsl',
        'log2(max(disc.texels * POISSON_RADIUS, 1.0))', '0.0'
    ],
    'occluders as deep as the mean' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        'before / hidden', 'before'
    ],
    'a penumbra of the other kind of light' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        'light_position.w == 0.0', 'light_position.w != 0.0'
    ],
    'a penumbra as wide as the light' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        'penumbra_width(here, occluder)', 'penumbra_width(here, nearest)'
    ],
    'a disc of twice the penumbra' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        '0.5 * width / texels', 'width / texels'
    ],
    'a circle that no perspective stretches' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        'cross(towards_light(receiver.relative_position), u)',
        'cross(towards_light(vec3(0.0)), u)'
    ],
    'a search that is as wide as the map' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        '1.0 / 8.0', '1.0'
    ],
    'one search, as wide as the light' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        'pow(LEAST_DISC / widest, part)', '1.0'
    ],
    'a tilted receiver taken for what is before it' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/penumbra.glsl',
        'min(deviation * deviation, 0.9 * variance)', '0.0'
    ],
    'a hybrid that is lit behind its occluders' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/visibility_hybrid.glsl',
        'plane - bias <= occluder', 'plane - bias > occluder'
    ],
    'a hybrid that compares one depth for all taps' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/visibility_hybrid.glsl',
        'receiver.depth + dot(slope, away)', 'receiver.depth'
    ],
    'a hybrid that reaches around its caster' => [
        'step5_soft', 'step5_chebyshev/techniques/soft/visibility_hybrid.glsl',
        'min(0.5 * disc.gap / LEAST_DISC, 1.0)', '1.0'
    ],
    'derivatives of x and y swapped' => [
        'step4_prefilters', 'step1_shadowmap/techniques/shared/steps.glsl',
        'dFdx(relative_position)', 'dFdy(relative_position)'
    ],
    'taps along the shorter axis' => [
        'step4_prefilters', 'step4_blur/techniques/mips/lookup_anisotropic.glsl',
        'pixel.direction * apart',
        'pixel.direction.yx * vec2(-1, 1) * apart'
    ],
    'every tap at one place' => [
        'step4_prefilters', 'step4_blur/techniques/mips/lookup_anisotropic.glsl',
        'receiver.uv + steps * tap_step', 'receiver.uv'
    ],
    'taps at the level of the longer axis' => [
        'step4_prefilters', 'step4_blur/techniques/mips/lookup_anisotropic.glsl',
        'max(pixel.shorter, tap_length)', 'pixel.longer'
    ],
    'an object drawn in the place of another' => [
        'step1', 'step1_shadowmap/base/leave_out/casters.c',
        'list->objects[place] = before;', ''
    ],
    'a face of a point light that is never looked up' => [
        'all_lights', 'step1_shadowmap/techniques/lights/layer_face.glsl',
        'return 2 * axis', 'return axis'
    ],
    'a running box that misses its own block' => [
        'step4_boxes', 'step4_blur/techniques/kernels/running_box.comp',
        'merge_add_sums(box', '// merge_add_sums(box'
    ],
    'a running box that takes what another one kept' => [
        'step4_boxes', 'step4_blur/techniques/kernels/running_box.comp',
        'before[width - 1 - i]', 'before[i]'
    ],
    'weights written with two digits' => [
        'all_truths', 'step4_blur/blur.c', '%s%.9g', '%s%.2g'
    ],
    'the constants of one filter for all' => [
        'step4_boxes', 'step4_blur/techniques/kernels/kernels.c',
        'running_box_program(&frame->shaders, sides)',
        'running_box_program(&frame->shaders, state.filters[0].sides)'
    ],
    'a block that begins one texel late' => [
        'step4_boxes', 'step4_blur/techniques/kernels/running_box.comp',
        'line_texel(start - i)', 'line_texel(start - i - 1)'
    ],
    'a running box about a depth that it does not hold' => [
        'step4_boxes', 'step4_blur/techniques/kernels/running_box.comp',
        'vec2 first = line_texel(start)', 'vec2 first = vec2(0.0)'
    ],
    'even boxes that lean to the same side' => [
        'step4_boxes', 'step4_blur/techniques/kernels/kernels.c',
        'weights[radius - sides[0]]', 'weights[0]'
    ],
    'a table summed along one axis' => [
        'step4_prefilters', 'step4_blur/techniques/sat/sat_sum.frag',
        'stride * axis', 'stride * ivec2(axis.x, 0)'
    ],
    'a running sum that begins late' => [
        'step4_prefilters', 'step4_blur/techniques/sat/sat_rows.comp',
        'ivec2(0, gl_GlobalInvocationID.x)', 'ivec2(1, gl_GlobalInvocationID.x)'
    ],
    'columns that are not summed' => [
        'step4_prefilters', 'step4_blur/techniques/sat/sat_columns.comp',
        'sum += imageLoad', 'sum = imageLoad'
    ],
    'a table whose ends are counted twice' => [
        'step4_prefilters', 'step4_blur/techniques/sat/sat_box.glsl',
        'first + int(floor(end))', 'first + int(floor(end)) + 1'
    ],
    'a box of whole texels only' => [
        'step4_prefilters', 'step4_blur/techniques/sat/sat_box.glsl',
        'vec3(1.0 - within, 1.0, end - floor(end))', 'vec3(1.0, 1.0, 0.0)'
    ],
    'a table of 16 bits' => [
        'step4_prefilters',
        'step4_blur/techniques/sat/sat_steps.glsl',
        'clamp(nearness, 0.0, 1.0) * float(steps) + 0.5',
        'floor(clamp(nearness, 0.0, 1.0) * 65536.0) * float(steps / 65536u)'
    ],
    'levels of a cube as coarse as there are' => [
        'all_seams', 'step4_blur/techniques/mips/mip_levels.glsl',
        'float last = float(last_level)', 'float last = 8.0'
    ],
    'taps along a pixel beyond the border of a face' => [
        'all_seams', 'step4_blur/techniques/mips/lookup_anisotropic.glsl',
        'return min(1.0, room / max(outermost, 1e-30))', 'return 1.0'
    ],
    'the texture unit always at level 0' => [
        'step4_sampler', 'step4_blur/techniques/mips/lookup_hardware.glsl',
        'steps.xy, steps.zw', '0.0 * steps.xy, 0.0 * steps.zw'
    ],
    'the border cut off before the blur' => [
        'all_seams',
        'step4_blur/shaders/map_texel.glsl',
        'return textureLod',
        'if (any(lessThan(texel, textureSize(map, 0).xy / 16)))'
          . ' { return vec2(1.0); } return textureLod'
    ],
    'a limit on the slope that grazing light passes' => [
        'all_scenes', 'step1_shadowmap/shaders/depth_slope.glsl',
        '0.02 * length', '0.1 * length'
    ],
    'half a shadow where there is none' => [
        'all_shadows',    'step1_shadowmap/base/leave_out/shaders/unshadowed.glsl',
        'return 1.0', 'return 0.5'
    ],
    'lit although it faces away, without shadows' => [
        'all_shadows',       'step1_shadowmap/shaders/scene.frag',
        'facing > 0.0', 'true'
    ],
    'what is no number, with one option only' => [
        'robustness/pairs', 'step5_chebyshev/techniques/smooth/reduction_smooth.glsl',
        'smoothstep(', 'sqrt(-1.0) * smoothstep('
    ],
    'facing away is not dark' => [
        'all_scenes',          'step1_shadowmap/shaders/scene.frag',
        'facing > 0.0', 'facing > -2.0'
    ],
    'a face that takes more than its share' => [
        'all_seams',
        'step1_shadowmap/techniques/lights/layer_face.glsl',
        'size.x >= max(size.y, size.z)',
        '1.2 * size.x >= max(size.y, size.z)'
    ],
    'a face of the light that is left out' => [
        'all_plan', 'step1_shadowmap/base/leave_out/volume.c',
        'along[axis] = (face % 2 ? -1 : 1)',
        'along[axis] = (face % 2 ? -1 : face == 4 ? -1 : 1)'
    ],
    'a rectangle that ends before its receivers' => [
        'all_looked_up',           'step1_shadowmap/base/leave_out/receivers.c',
        ') + MARGIN_TEXELS;', ') - 2 * MARGIN_TEXELS;'
    ],
    'a blur that reads beyond what was drawn' => [
        'all_plan', 'step1_shadowmap/base/leave_out/leave_out.c',
        'target->reach[0], target->reach[1], size',
        'target->reach[0] / 2, target->reach[1], size'
    ],
    'blocks that start where the rectangle does' => [
        'all_plan',
        'step4_blur/techniques/kernels/running_box.c',
        'low / width * width + sides[1]',
        'low + sides[1]'
    ],
    'a level of the chain that is not wide enough' => [
        'all_plan', 'step1_shadowmap/base/leave_out/leave_out.c',
        'frame->views.width / target->width',
        'frame->views.width * 2 / target->width'
    ],
    'what is half in the picture is left out' => [
        'all_plan',        'step1_shadowmap/base/leave_out/volume.c',
        'beyond == 8', 'beyond >= 4'
    ],
    'the camera and the picture\'s lower edge mixed up' => [
        'all_plan',
        'step1_shadowmap/base/leave_out/volume.c',
        'add_slab(&volume, clip[1], clip[3])',
        'add_slab(&volume, clip[1], clip[0])'
    ],
    'a plane that no bias keeps lit' => [
        'all_plan', 'step1_shadowmap/base/leave_out/lone_plane.c',
        'lookups->slope_bias >= 1',
        'lookups->slope_bias >= 0'
    ],
    'a plane that hardly varies is lit' => [
        'all_plan', 'step1_shadowmap/base/leave_out/lone_plane.c',
        '0x1p-26 *',
        '0x1p25 *'
    ],
    'a plane that is behind its own bias' => [
        'all_plan', 'step1_shadowmap/base/leave_out/lone_plane.c',
        'lookups->bias > lookups->rounding',
        '1 > lookups->rounding'
    ],
    'a lookup of a map that does not reach so far' => [
        'all_looked_up',
        'step1_shadowmap/techniques/splits/scene_splits.frag',
        'inside_map(receiver) ? visibility(receiver) : 1.0',
        'mix(1.0, visibility(receiver), float(inside_map(receiver)))'
    ],
    'a lookup that was left out is shown' => [
        'all_looked_up',
        'step1_shadowmap/base/leave_out/shaders/show_plan_nothing.glsl',
        'scale_color(0.0)', 'scale_color(0.5)'
    ],
    'a shader that a window compiles when it first needs it' => [
        'robustness/window', 'step1_shadowmap/base/run/run.c',
        'gl_compile(&frame->shaders);', ''
    ],
    'a byte order mark that is compiled' => [
        'robustness/bad_input', 'step1_shadowmap/base/gl/shader_file.c',
        'strncmp(text, mark, strlen(mark)) == 0', '0'
    ],
    'a shader that is cut at a zero byte' => [
        'robustness/bad_input', 'step1_shadowmap/base/gl/shader_file.c',
        ' || strlen(text) != length', ''
    ],
    'shaders where nobody looks for them' => [
        'robustness/bad_input', 'step1_shadowmap/base/files/shaders.c',
        'strncmp(entry->d_name, "step", 4) == 0', 'entry->d_name[0] != 0'
    ],
    'a bias may push receivers behind what is left out' => [
        'all_plan', 'step1_shadowmap/base/leave_out/leave_out.c',
        'lookups->bias >= 0 &&',
        ''
    ],
    'what is behind some receiver is left out' => [
        'all_plan', 'step1_shadowmap/base/leave_out/leave_out.c',
        '? left->layer[layer].deepest',
        '? 0.5 * left->layer[layer].deepest'
    ],
    'moments without what is behind all receivers' => [
        'all_plan', 'step1_shadowmap/base/leave_out/leave_out.c',
        'lookups->compares &&',
        ''
    ],
    'an object that moves and leaves its shadow' => [
        'all_plan', 'step1_shadowmap/base/leave_out/leave_out.c',
        'object->transform, sizeof object->transform',
        'object->albedo, sizeof object->albedo'
    ],
    'the table says of another truth how wrong' => [
        'robustness/table', 'tests/report/table.sh',
        'rmse["hard"]', 'rmse["pcf"]'
    ],
    'a table in the user\'s locale' => [
        'robustness/locale', 'tests/report/table.sh', 'export LC_ALL=C', ':'
    ],
    'a script in the user\'s locale' => [
        'robustness/locale', 'tests/report/headline.sh',
        'export LC_ALL=C', ':'
    ],
    'an install that says no size' =>
      [ 'robustness/set_up', 'step1_shadowmap/base/set-up.sh', ': $cost;', ';' ],
    'a system without OSMesa like any other' => [
        'robustness/set_up', 'step1_shadowmap/base/set-up.sh',
        '*libosmesa6-dev*)', 'libosmesa6-dev)'
    ],
    'an install that asks questions under sudo' => [
        'robustness/set_up', 'step1_shadowmap/base/set-up.sh',
        '$as_root env DEBIAN_FRONTEND=noninteractive',
        'DEBIAN_FRONTEND=noninteractive $as_root'
    ],
    'a copy that does not look for packages' => [
        'robustness/set_up', 'step1_shadowmap/base/base.mk',
        'glad/gl.h: | set-up', 'glad/gl.h:',
        'step1_shadowmap/base/base.mk', '$(ROOT)/%.cpp | set-up',
        '$(ROOT)/%.cpp'
    ],
    'what somebody drew by hand stays' => [
        'robustness/pictures', 'Makefile',
        '$(MADE_FROM) $(PICTURES)', '$(MADE_FROM)'
    ],
    'a table that takes the strip with it' => [
        'robustness/pictures', 'Makefile',
        '$(BUILD)/strip $@ $(PICTURES)',
        '$(BUILD)/strip $@ $(PICTURES) && sh tests/report/table.sh $(BUILD)'
    ],
    'a picture twice in the strip' => [
        'robustness/pictures', 'tests/report/strip.c',
        'opened(argv[i + 2])', 'opened(argv[2])'
    ],
    'every answer is right' => [
        'robustness/exercise', 'tests/exercise/Marks.pm',
        '/^FAIL (.*)/ ? $1', '/^FAIL (.*)/ ? ()'
    ],
    'marks for what suits the first run only' => [
        'robustness/exercise', 'tests/exercise/Marks.pm',
        'mark_run( $step, \%run, $text, $keep ) or', '() or'
    ],
    'a whole program that suits the first run only' => [
        'robustness/exercise', 'tests/exercise/Marks.pm',
        '( [], map', '( [], grep { 0 } map'
    ],
    'a picture that is there already' => [
        'robustness/grade', 'tests/exercise/Submission.pm',
        '".$name.$$"', '$name'
    ],
    'marks that leave their temporary files' => [
        'robustness/grade', 'tests/exercise/grade.pl',
        'INT PIPE TERM USR1', 'INT TERM'
    ],
    'what does not end is right' => [
        'robustness/exercise', 'tests/exercise/Marks.pm',
        'my $signal = $run->{signal};', 'my $signal = 0;'
    ],
    'the last known mistake is everybody\'s' => [
        'robustness/exercise', 'tests/exercise/Marks.pm',
        '|| $away > $least', ''
    ],
    'marks for pixels that are not drawn' => [
        'robustness/exercise', 'tests/exercise/Marks.pm',
        '|| $largest > $ELSEWHERE', ''
    ],
    'a shader with memory without end' => [
        'robustness/grade', 'tests/exercise/Marks.pm',
        ' --as=1000000000', ''
    ],
    'a shader that outlives its marking' => [
        'robustness/grade', 'tests/exercise/Marks.pm',
        'setpriv --pdeathsig KILL ', ''
    ],
    'marks with escape sequences' => [
        'robustness/grade', 'tests/exercise/Submission.pm',
        '\p{C}', ''
    ],
    'a link on the way is followed' => [
        'robustness/grade', 'tests/exercise/Submission.pm',
        'enter( $_,   O_NOFOLLOW )', 'enter( $_, 0 )'
    ],
    'what is no plain file is read' => [
        'robustness/grade', 'tests/exercise/Submission.pm',
        '    -f _ or die', '    -e _ or die'
    ],
    'a picture of the marks before' => [
        'robustness/exercise', 'tests/exercise/Submission.pm',
        'sub { unlink $name }', 'sub { 1 }'
    ],
    'an exercise with its solution' => [
        'robustness/exercise', 'tests/exercise/Tasks.pm',
        '$text =~ s', '( my $empty = $text ) =~ s'
    ],
    'an exercise in whose place a technique stands' => [
        'robustness/exercise', 'tests/exercise/Lessons.pm',
        '--min-variance 0.01', '--variance-bias 1e-3'
    ],
    'what was changed besides the functions' => [
        'robustness/exercise', 'tests/exercise/Marks.pm',
        '&& $largest <= $VISIBLE', ''
    ],
    'a test that removes what it did not make' => [
        'robustness/own_folders', 'tests/lib/VSM.pm',
        'go_to($empty) if $here', 'go_to($empty) if !$here'
    ],
    'dumps of two processes in one folder' => [
        'robustness/own_folders',
        'tests/lib/VSM.pm',
        'my $folder = $dumps{$key} // tempdir( CLEANUP => 1 )',
        'my $folder = $dumps{$key} // "$BUILD/test"; make_path($folder)'
    ],
    'a failure at the line of what the tests share' => [
        'robustness/failing',
        'tests/lib/Failing.pm',
        '$where.\n$again', '$file line $line.\n$again'
    ],
    'a failure that fills the screen' => [
        'robustness/failing', 'tests/lib/Failing.pm',
        'short( named( $event->message ) )', 'named( $event->message )'
    ],
    'a command that cannot be pasted' => [
        'robustness/failing', 'tests/lib/Failing.pm',
        "if \$word !~", "if 0 && \$word !~"
    ],
    'a map that is drawn again for what is elsewhere' => [
        'robustness/touched', 'step1_shadowmap/base/leave_out/leave_out.c',
        'made_from != left->layer[layer].drawn_from',
        'made_from + 1 != left->layer[layer].drawn_from'
    ],
    'casters only where receivers are' => [
        'all_plan', 'step1_shadowmap/base/leave_out/casters.c',
        'high[axis] = (texels->high[axis] + 1.0)',
        'high[axis] = (texels->low[axis] + 1.0)'
    ],
    'a word that make evaluates' => [
        'robustness/words',   'step1_shadowmap/base/words.mk',
        '$(filter command,', '$(filter nobody,'
    ],
    'a STEP that is not checked' => [
        'robustness/words', 'Makefile',
        '[$(value STEP)]',  '[5]'
    ],
    'a copy that writes over a folder' => [
        'robustness/words', 'step1_shadowmap/base/standalone.sh',
        '[ -z "$files" ]',  'true'
    ],
    'a copy that does not see hidden files' => [
        'robustness/words', 'step1_shadowmap/base/standalone.sh',
        'ls -Aq',           'ls -q'
    ],
    'a copy that is taken for a step' => [
        'robustness/words', 'step1_shadowmap/base/standalone.sh',
        '"$(pwd -P)"/step* | ', ''
    ],
    'a command that is printed without quotes' => [
        'robustness/words', 'step1_shadowmap/base/standalone.sh',
        '*[!A-Za-z0-9./_-]*', 'nothing'
    ],
    'a path of the tree that a shell reads' => [
        'robustness/words',    'tests/lib/VSM.pm',
        q{$program, 'serve' }, '$program '
    ],
    'a path of the tree that is a pattern' => [
        'robustness/words', 'tests/lib/VSM.pm',
        '$folder =~ s/([][{}*?~\\\\])/\\\\$1/gr . ', '$folder . '
    ],
);

sub read_file {
    my ($path) = @_;
    open my $file, '<', $path or die "cannot read $path: $!\n";
    local $/;
    return <$file>;
}

# Copies of these below a folder, with their times, so that a change costs one
# file to compile.
sub copy_to {
    my ( $folder, @copied ) = @_;
    system( 'cp', '-a', '--parents', @copied, $folder ) == 0
      or die "cannot copy to $folder\n";
    return;
}

# What the programs are made from and what has been made of it.
my @SOURCES = (
    'Makefile', 'tests/tests.mk', glob('step*'), glob('build/obj/step*'),
    'build/glad'
);
my @ORACLE = qw(tests/oracle tests/stability build/obj/tests);
my @REPORT = qw(Makefile tests/tests.mk tests/lib tests/exercise tests/report
  tests/robustness tests/stability README.md .gitignore);

sub build_in {
    my ( $folder, $target ) = @_;
    system( 'sh', '-c', 'make -C "$0" DEPS=no "$1" >"$0/log" 2>&1',
        $folder, $target ) == 0
      or die "the mutant does not build:\n" . read_file("$folder/log");
    return;
}

# Plants the changes into a folder. Returns where the test is to run, and what
# its environment is to say so that it finds them there.
sub plant {
    my @change = @_;
    my $folder = tempdir( CLEANUP => 1 );
    my ($kind) = map { /\.(cpp|c|h|p[lm]|sh)$/ ? $1 : () } @change;
    $kind //= 'shader';
    $kind = 'c' if $change[0] =~ /^step.*cpp$/;    # of the programs
    # What a test itself makes, from the tree that it is in.
    $kind = 'sh' if $change[0] =~ /Makefile$|\.mk$|strip\.c$/;
    copy_to( $folder, @REPORT, glob('step*') ) if $kind =~ /^(?:p|sh$)/;
    copy_to( $folder, @SOURCES ) if $kind =~ /^(?:c|h|cpp)$/;
    copy_to( $folder, @ORACLE )  if $kind eq 'cpp';
    plant_one( $folder, splice @change, 0, 3 ) while @change;
    return ( '.', VSM_SHADERS => $folder ) if $kind eq 'shader';
    return ( $folder, VSM_BUILD => abs_path('build') ) if $kind =~ /^(?:p|sh$)/;
    my @kept = $kind eq 'cpp' ? glob('build/step*') : 'build/oracle';
    symlink abs_path($_), "$folder/$_" for @kept;
    build_in( $folder, $kind eq 'cpp' ? 'build/oracle' : 'programs' );
    return ( '.', VSM_BUILD => "$folder/build" );
}

sub plant_one {
    my ( $folder, $path, $from, $to ) = @_;
    my $source = -e "$folder/$path" ? "$folder/$path" : $path;
    my $text   = planted( $path, read_file($source), $from, $to );
    make_path( dirname("$folder/$path") );
    open my $file, '>', "$folder/$path" or die "cannot write: $!\n";
    print {$file} $text;
    close $file or die "cannot write: $!\n";
    return;
}

# The first test that fails with these in its environment, or nothing. The
# tests after it are not run: one is enough.
sub first_failure {
    my ( $test, $folder, %where ) = @_;
    my $own = File::Temp->newdir;    # what a test leaves that is stopped
    local @ENV{ 'TMPDIR', keys %where } = ( "$own", values %where );
    local $ENV{VSM_PATIENCE} = 20;    # seconds for a window that does not react
    my $file = 'tests/' . ( $test =~ m{/} ? '' : 'images/' ) . "$test.t";
    my $child = open my $tap, '-|', 'sh', '-c',
      'cd "$0" && exec perl -Itests/lib "$1" 2>/dev/null', $folder, $file
      or die "cannot run perl: $!\n";
    while (<$tap>) {
        next unless /^not ok \d+ - ((?!.*# TODO).*)$/;
        my $failure = $1;
        kill 'TERM', $child;
        close $tap;
        return $failure;
    }
    return if close $tap;
    die "the mutant does not run: @{[ %where ]}\n";
}

# Judges these mutants, a line each.
sub judge {
    for my $name (@_) {
        my ( $test, @change ) = @{ $mutants{$name} };
        my $failure = first_failure( $test, plant(@change) );
        printf "%-8s %s: %s.t, %s\n",
          defined $failure ? 'caught' : 'SURVIVED', $name, $test,
          $failure // 'no test failed';
    }
    return;
}

my @names = @ARGV ? @ARGV : sort keys %mutants;
$mutants{$_} or die "there is no mutant '$_'\n" for @names;

# Two workers, every other mutant each.
$| = 1;
my %lines;
my @workers;
for my $first ( 0, 1 ) {
    my $child = open my $lines, '-|';
    defined $child or die "cannot fork: $!\n";
    if ( !$child ) {
        judge( @names[ grep { $_ % 2 == $first } 0 .. $#names ] );
        print "done\n";
        exit 0;
    }
    push @workers, $lines;
}
for my $lines (@workers) {
    while ( my $line = <$lines> ) {
        $lines{ $line =~ /^(\w+)/ ? $1 : '' }++;
        print $line if $line ne "done\n";
    }
}
printf "%d caught, %d survived\n", map { $lines{$_} // 0 } qw(caught SURVIVED);
( $lines{done} // 0 ) == 2 or die "not every mutant was judged\n";
exit( $lines{SURVIVED} ? 1 : 0 );
