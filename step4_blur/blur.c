#include "step4_blur/blur.h"

#include <math.h>   // exp
#include <stdio.h>  // snprintf
#include <stdlib.h> // free
#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h" // allocate, die_usage
#include "step4_blur/running_box.h"          // running_box_apply

static double kernel_weight(const char *name, int radius, int offset)
{
    double weight = 1; // box, and each of several boxes
    if (strcmp(name, "gaussian") == 0) {
        double deviation = radius / 3.0;
        weight = exp(-0.5 * offset * offset / (deviation * deviation));
    } else if (strcmp(name, "binomial") == 0) {
        // 2 radius over (radius + offset), as a product.
        for (int i = 1; i <= radius + offset; i++) {
            weight *= (double)(2 * radius + 1 - i) / i;
        }
    }
    return weight;
}

void blur_weights(const char *name, const int sides[2], float weights[])
{
    double sum = 0;
    for (int i = -sides[0]; i <= sides[1]; i++) {
        sum += kernel_weight(name, sides[0], i);
    }
    for (int i = -sides[0]; i <= sides[1]; i++) {
        weights[i + sides[0]] = (float)(kernel_weight(name, sides[0], i) / sum);
    }
}

static double filter_variance(const BlurSettings *settings, const int sides[2])
{
    float weights[2 * 1024 + 1];
    double mean = 0, square = 0;
    blur_weights(settings->kernel, sides, weights);
    for (int i = -sides[0]; i <= sides[1]; i++) {
        mean += (double)weights[i + sides[0]] * i;
        square += (double)weights[i + sides[0]] * i * i;
    }
    return square - mean * mean;
}

double blur_spread(const BlurSettings *settings)
{
    BlurSides filters[BLUR_MAX_FILTERS];
    int count = blur_filters(settings, filters);
    double texel = settings->downsample, variance = 0;
    if (settings->mips || settings->sat) {
        return 0;
    }
    for (int i = 0; i < count; i++) {
        variance += filter_variance(settings, filters[i].sides);
    }
    return texel * texel * variance;
}

Lookups blur_lookups(const BlurSettings *settings,
                     const MomentsSettings *moments, const BiasSettings *bias)
{
    int reach = blur_reach(settings);
    bool mean = !settings->mips && !settings->sat; // about its own place
    return bias_lookups(bias, reach, mean ? 2 * reach + 1 : 0,
                        moments_format(moments));
}

// The program of a pass that averages texels.
static Program *merge_program(Frame *frame, const MomentsSettings *moments,
                              const char *constants, const char *pass)
{
    const char *vertex[] = {"step1_shadowmap/shaders/fullscreen.vert", NULL};
    const char *fragment[] = {moments_merge_shader(moments),
                              moments_store_shader(moments),
                              "step4_blur/shaders/map_texel.glsl", pass, NULL};
    return gl_program(&frame->shaders, constants, vertex, fragment);
}

// What the program of one filter takes for constants: a loop over texels whose
// number is known gets unrolled, in half the time (measured). Running boxes
// need no weights.
static char *filter_constants(const BlurSettings *settings, const int sides[2],
                              bool running)
{
    enum { START_BYTES = 128, WEIGHT_BYTES = 20 };
    int width = sides[0] + 1 + sides[1];
    size_t bytes = START_BYTES + WEIGHT_BYTES * (size_t)width;
    char *text = allocate(bytes, 1);
    size_t end = (size_t)snprintf(
        text, bytes, "const ivec2 sides = ivec2(%d, %d);", sides[0], sides[1]);
    if (running) {
        return text;
    }
    float *weights = allocate((size_t)width, sizeof *weights);
    blur_weights(settings->kernel, sides, weights);
    end += (size_t)snprintf(text + end, bytes - end,
                            " const float weights[%d] = float[](", width);
    for (int i = 0; i < width; i++) {
        end += (size_t)snprintf(text + end, bytes - end, "%s%.9g",
                                i == 0 ? "" : ", ", (double)weights[i]);
    }
    snprintf(text + end, bytes - end, ");");
    free(weights);
    return text;
}

// Up to this radius the lesson's own shader runs, in fragments. (Running boxes
// take about half as long there, too.)
enum { FRAGMENTS_RADIUS = 3 };

bool blur_runs(const BlurSettings *settings, const MomentsSettings *moments)
{
    if (strcmp(settings->by, "compute") == 0 && !gl_has_compute()) {
        die_usage("--blur-by compute needs OpenGL 4.3, and this driver has no "
                  "compute shaders: drop --blur-by");
    }
    if (strcmp(settings->by, "auto") != 0) {
        return strcmp(settings->by, "compute") == 0;
    }
    return gl_has_compute() && blur_can_run(settings, moments) &&
           blur_used_radius(settings) > FRAGMENTS_RADIUS;
}

// A map like the source, smaller by a factor of which each texel is made.
static Target smaller_map(const Target *source, const char *pass, int factor)
{
    return (Target){.pass = pass,
                    .kind = TARGET_LAYERS,
                    .width = source->width / factor,
                    .height = source->height / factor,
                    .layers = source->layers,
                    .formats = {source->formats[0]},
                    .sampling = source->sampling};
}

static void add_not_asked(Blur *blur, Frame *frame, const char *pass,
                          const char *why)
{
    Target *target = blur->not_asked;
    while (target->pass != NULL) {
        target++;
    }
    *target = (Target){
        .pass = pass, .why = why, .kind = TARGET_NOTHING, .idle = true};
    target_add(&frame->targets, target);
}

static Target *create_small(Blur *blur, Frame *frame, const Moments *moments)
{
    int factor = blur->settings->downsample;
    bool alone = blur->settings->mips && blur_used_radius(blur->settings) == 0;
    if (factor == 1) {
        add_not_asked(blur, frame, "downsampling", "--downsample 1");
    }
    // A chain needs a texture of its own, and the moments' is not ours.
    if (factor == 1 && !alone) {
        return blur->source;
    }
    blur->small =
        smaller_map(blur->source, factor > 1 ? "downsampling" : "copy", factor);
    blur->small.why = factor > 1 ? "--downsample" : "of which --mips are made";
    blur->small.reads = blur->source;
    blur->small.scale = factor;
    blur->downsample = merge_program(frame, moments->settings, NULL,
                                     "step4_blur/shaders/downsample.frag");
    target_add(&frame->targets, &blur->small);
    return &blur->small;
}

static const char *blur_shader(const MomentsSettings *settings)
{
    return moments_are_central(settings)
               ? "step4_blur/shaders/blur_central.frag"
               : "step4_blur/shaders/blur.frag";
}

static void create_program(Blur *blur, Frame *frame, const Moments *moments,
                           int filter)
{
    char *constants = filter_constants(
        blur->settings, blur->filters[filter].sides, blur->running);
    blur->programs[filter] =
        blur->running
            ? running_box_program(&frame->shaders, constants, moments->settings)
            : merge_program(frame, moments->settings, constants,
                            blur_shader(moments->settings));
    free(constants);
}

// All filters along u, then all along v: an even number, by turns between two
// textures. A pass reads as many texels around its own as its filter holds to
// the wider side.
static Target *create_passes(Blur *blur, Frame *frame, Target *source,
                             const Moments *moments)
{
    int count = blur->filter_count =
        blur_filters(blur->settings, blur->filters);
    blur->running = count > 0 && blur_runs(blur->settings, moments->settings);
    for (int i = 0; i < count; i++) {
        create_program(blur, frame, moments, i);
    }
    for (int i = 0; i < 2 * count; i++) {
        const int *sides = blur->filters[i % count].sides;
        Target *pass = &blur->passes[i];
        *pass =
            smaller_map(source, i < count ? "blur along u" : "blur along v", 1);
        pass->why = blur->running ? "by running boxes in compute shaders"
                                  : "by fragments";
        pass->shares = i < 2 ? NULL : &blur->passes[i % 2];
        pass->reads = source;
        pass->scale = 1;
        pass->reach[i / count] = sides[0] > sides[1] ? sides[0] : sides[1];
        target_add(&frame->targets, pass);
        source = pass;
    }
    if (count == 0) {
        add_not_asked(blur, frame, "blur", "radius 0: it would copy the map");
    }
    return source;
}

static void create_mips(Blur *blur, Frame *frame, Target *source,
                        const Moments *moments)
{
    const BlurSettings *settings = blur->settings;
    Target *owner = source->shares != NULL ? source->shares : source;
    const int size[2] = {source->width, source->height};
    if (!settings->mips) {
        add_not_asked(blur, frame, mips_pass, "no lookup reads any");
        return;
    }
    if (blur_uses_hardware(settings)) {
        mips_check_sampler(source->layers, settings->anisotropy);
        blur->mips.anisotropy = settings->anisotropy;
    }
    mips_create(&blur->mips, frame,
                merge_program(frame, moments->settings, NULL,
                              "step4_blur/shaders/mips.frag"),
                owner, source,
                blur_last_level(settings, &frame->views, mips_count(size)),
                settings->anisotropy > 1 ? TARGET_EVERYWHERE : 1);
}

// What the picture reads of the result around the receiver's place: 2 x 2
// texels, or just outside of a table's box too. Taps along the pixel's longer
// axis may be anywhere.
static int lookup_reach(const BlurSettings *settings)
{
    return settings->anisotropy > 1 ? TARGET_EVERYWHERE
           : settings->sat          ? blur_used_radius(settings) + 2
                                    : 1;
}

static void create_result(Blur *blur, Frame *frame, Target *source)
{
    blur->result = smaller_map(source, NULL, 1);
    blur->result.shares = blur->result.reads = source;
    blur->result.scale = 1;
    blur->result.file = blur->settings->sat ? NULL : "blurred";
    blur->result.looked_up = lookup_reach(blur->settings);
    target_add(&frame->targets, &blur->result);
}

void blur_create(Blur *blur, Frame *frame, const BlurSettings *settings,
                 Moments *moments)
{
    blur->settings = settings;
    blur->source = &moments->target;
    Target *source = create_small(blur, frame, moments);
    if (settings->sat) {
        add_not_asked(blur, frame, "blur", "the table holds every box");
    } else {
        source = create_passes(blur, frame, source, moments);
    }
    create_mips(blur, frame, source, moments);
    if (settings->sat) {
        source = sat_create(&blur->sat, frame, source,
                            blur_used_radius(settings), settings->sat_by);
    } else {
        add_not_asked(blur, frame, "summed-area table", "no lookup reads it");
    }
    create_result(blur, frame, source);
}

static void downsample(Blur *blur, const Frame *frame)
{
    GLuint program = gl_use(blur->downsample);
    glUniform1i(glGetUniformLocation(program, "factor"), blur->small.scale);
    frame_filter(frame, program, target_texture(blur->source), &blur->small);
}

static void blur_along(Blur *blur, const Frame *frame, int pass)
{
    int axis = pass / blur->filter_count, filter = pass % blur->filter_count;
    Target *target = &blur->passes[pass];
    GLuint source = target_texture(target->reads);
    GLuint program = gl_use(blur->programs[filter]);
    glUniform2i(glGetUniformLocation(program, "axis"), 1 - axis, axis);
    if (blur->running) {
        running_box_apply(program, source, target, axis,
                          blur->filters[filter].sides);
    } else {
        frame_filter(frame, program, source, target);
    }
}

// The passes read single texels of a map.
static GLuint bind_sampler(const Target *map)
{
    Sampling single = map->sampling;
    single.filter = GL_NEAREST;
    GLuint sampler = gl_sampler(single);
    glBindSampler(0, sampler);
    return sampler;
}

void blur_apply(Blur *blur, const Frame *frame)
{
    if (!frame->looks_up && frame->dump == NULL) {
        return;
    }
    GLuint sampler = bind_sampler(blur->source);
    if (blur->downsample != NULL) {
        downsample(blur, frame);
    }
    for (int i = 0; i < 2 * blur->filter_count; i++) {
        blur_along(blur, frame, i);
    }
    if (blur->mips.levels > 0) {
        mips_apply(&blur->mips, frame);
    }
    if (blur->settings->sat) {
        sat_apply(&blur->sat, frame);
    }
    glBindSampler(0, 0);
    glDeleteSamplers(1, &sampler);
}
