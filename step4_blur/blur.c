#include "step4_blur/blur.h"

#include <math.h>   // exp
#include <stdio.h>  // snprintf
#include <stdlib.h> // free
#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h" // allocate, die_usage
#include "step4_blur/running_box.h"          // running_box_apply

static BlurTarget create_target(Blur *blur, const ShadowMap *map)
{
    blur->bytes += (size_t)blur->width * (size_t)blur->height *
                   (size_t)blur->layers * gl_texel_bytes(map->format);
    BlurTarget target = {.texture = gl_texture_array(map->format, blur->width,
                                                     blur->height, blur->layers,
                                                     map->sampling)};
    for (int layer = 0; layer < blur->layers; layer++) {
        target.framebuffers[layer] =
            gl_layer_framebuffer(target.texture, layer, 0);
    }
    return target;
}

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

// The program of a pass that averages texels.
static Program merge_program(ShaderFiles files, const MomentsSettings *moments,
                             const char *pass)
{
    const char *vertex[] = {"step1_shadowmap/shaders/fullscreen.vert", NULL};
    const char *fragment[] = {moments_merge_shader(moments),
                              moments_store_shader(moments),
                              "step4_blur/shaders/map_texel.glsl", pass, NULL};
    return gl_program(files, vertex, fragment);
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

static void create_filters(Blur *blur, ShaderFiles files,
                           const BlurSettings *settings,
                           const MomentsSettings *moments)
{
    blur->filter_count = blur_filters(settings, blur->filters);
    blur->running = blur_runs(settings, moments);
    for (int i = 0; i < blur->filter_count; i++) {
        blur->constants[i] =
            filter_constants(settings, blur->filters[i].sides, blur->running);
        files.constants = blur->constants[i];
        blur->blur_programs[i] =
            blur->running
                ? running_box_program(files, moments)
                : merge_program(files, moments, "step4_blur/shaders/blur.frag");
    }
}

Blur blur_create(ShaderFiles files, const BlurSettings *settings,
                 const MomentsMap *moments_map)
{
    const MomentsSettings *moments = moments_map->settings;
    const ShadowMap *map = &moments_map->texels;
    Blur blur = {.factor = settings->downsample,
                 .radius = settings->sat ? 0 : blur_used_radius(settings),
                 .anisotropy = settings->anisotropy,
                 .hardware = blur_uses_hardware(settings),
                 .width = map->width / settings->downsample,
                 .height = map->height / settings->downsample,
                 .layers = map->layers};
    const int size[2] = {blur.width, blur.height};
    glGenVertexArrays(1, &blur.empty_vao);
    Sampling single = map->sampling;
    single.filter = GL_NEAREST;
    blur.texel_sampler = gl_sampler(single);
    // A chain needs a texture of its own, and the moments' is not ours.
    if (blur.factor > 1 || (settings->mips && blur.radius == 0)) {
        blur.downsample_program =
            merge_program(files, moments, "step4_blur/shaders/downsample.frag");
        blur.small = create_target(&blur, map);
    }
    if (blur.radius > 0) {
        create_filters(&blur, files, settings, moments);
        blur.horizontal = create_target(&blur, map);
        blur.vertical = create_target(&blur, map);
    }
    if (settings->mips) {
        const BlurTarget *last = blur.radius > 0 ? &blur.vertical : &blur.small;
        blur.mips = mips_create(
            merge_program(files, moments, "step4_blur/shaders/mips.frag"),
            last->texture, map, size);
        blur.bytes += blur.mips.bytes;
        if (blur.hardware) {
            mips_use_sampler(&blur.mips, settings->anisotropy);
        }
    }
    if (settings->sat) {
        blur.sat = sat_create(files, size, blur.layers,
                              blur_used_radius(settings), settings->sat_by);
        blur.bytes += blur.sat.bytes;
    }
    return blur;
}

// The texels that a pass writes, by layer, of the layers that the plan draws.
typedef struct Part {
    const Rect *rects;
    const MapPlan *plan;
} Part;

// Draws these of the target from the same layer of the source.
static void draw_layers(const Blur *blur, GLuint program, GLuint source,
                        const BlurTarget *target, Part part)
{
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, source);
    glUniform1i(glGetUniformLocation(program, "map"), 0);
    for (int layer = 0; layer < blur->layers; layer++) {
        if (part.plan->layers[layer].draw) {
            gl_limit(&part.rects[layer]);
            glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffers[layer]);
            glUniform1i(glGetUniformLocation(program, "layer"), layer);
            gl_draw_fullscreen(blur->empty_vao);
        }
    }
    gl_unlimit();
}

static void downsample(const Blur *blur, GLuint source, Part part)
{
    GLuint program = blur->downsample_program.id;
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "factor"), blur->factor);
    draw_layers(blur, program, source, &blur->small, part);
}

static void blur_along(const Blur *blur, int axis, int filter, GLuint source,
                       const BlurTarget *target, Part part)
{
    GLuint program = blur->blur_programs[filter].id;
    if (blur->running) {
        running_box_apply(program, source, target->texture, part.rects,
                          part.plan, axis, blur->filters[filter].sides);
        return;
    }
    glUseProgram(program);
    glUniform2i(glGetUniformLocation(program, "axis"), 1 - axis, axis);
    draw_layers(blur, program, source, target, part);
}

// All filters along u, then all along v: an even number, between two targets.
static GLuint blur_axes(const Blur *blur, GLuint source, const BlurPlan *plan)
{
    const BlurTarget *targets[] = {&blur->horizontal, &blur->vertical};
    int count = blur->filter_count;
    for (int i = 0; i < 2 * count; i++) {
        const BlurTarget *target = targets[i % 2];
        blur_along(blur, i / count, i % count, source, target,
                   (Part){plan->passes[i], &plan->map});
        source = target->texture;
    }
    return source;
}

void blur_apply(Blur *blur, const MomentsMap *moments, const BlurPlan *plan)
{
    GLuint result = moments->texels.texture;
    glDisable(GL_DEPTH_TEST);
    glViewport(0, 0, blur->width, blur->height);
    glBindSampler(0, blur->texel_sampler);
    if (blur->downsample_program.id != 0) {
        downsample(blur, result, (Part){plan->small, &plan->map});
        result = blur->small.texture;
    }
    if (blur->radius > 0) {
        result = blur_axes(blur, result, plan);
    }
    if (blur->mips.levels > 0) {
        mips_apply(&blur->mips, result, blur->empty_vao, plan->levels,
                   &plan->map);
    }
    if (blur->sat.layers > 0) {
        result = sat_apply(&blur->sat, result, blur->empty_vao, plan->levels[0],
                           &plan->map);
    }
    glBindSampler(0, 0);
    blur->result = result;
    blur->touched = blur_plan_touched(plan, blur, moments->texels.format);
}

bool blur_reload(Blur *blur)
{
    bool compiled = gl_program_reload(&blur->downsample_program);
    for (int i = 0; i < blur->filter_count; i++) {
        compiled = compiled && gl_program_reload(&blur->blur_programs[i]);
    }
    return compiled && gl_program_reload(&blur->mips.program) &&
           sat_reload(&blur->sat);
}

static void destroy_target(const Blur *blur, BlurTarget *target)
{
    glDeleteFramebuffers(blur->layers, target->framebuffers);
    glDeleteTextures(1, &target->texture);
}

void blur_destroy(Blur *blur)
{
    // The name 0, of what was never created, is ignored.
    sat_destroy(&blur->sat);
    mips_destroy(&blur->mips);
    destroy_target(blur, &blur->vertical);
    destroy_target(blur, &blur->horizontal);
    destroy_target(blur, &blur->small);
    for (int i = 0; i < blur->filter_count; i++) {
        gl_program_destroy(&blur->blur_programs[i]);
        free(blur->constants[i]);
    }
    gl_program_destroy(&blur->downsample_program);
    glDeleteSamplers(1, &blur->texel_sampler);
    glDeleteVertexArrays(1, &blur->empty_vao);
    *blur = (Blur){.width = 0};
}
