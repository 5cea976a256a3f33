#include "step4_blur/blur.h"

#include <stdio.h>  // snprintf
#include <stdlib.h> // free

#include "step1_shadowmap/base/system/die.h" // allocate, die_usage

const Option blur_options[] = {
    {"radius", OPTION_INTEGER, offsetof(BlurSettings, radius), 0, 1024, NULL,
     "N", "the filter is 2 N + 1 texels wide, of the map it runs on"},
    {"downsample", OPTION_INTEGER, offsetof(BlurSettings, downsample), 1, 16,
     NULL, "N", "average N x N texels into one before the blur"},
    {0},
};

BlurSettings blur_settings(void)
{
    return (BlurSettings){.radius = 3, .downsample = 1};
}

void blur_check(const BlurSettings *settings, const BaseSettings *base)
{
    const int *size = base->map_size;
    for (int axis = 0; axis < 2; axis++) {
        int side = size[axis] / settings->downsample;
        if (size[axis] % settings->downsample != 0) {
            die_usage("--downsample %d does not divide --map-size %dx%d",
                      settings->downsample, size[0], size[1]);
        }
        if (settings->radius > 0 && 2 * settings->radius + 1 > side) {
            die_usage("--radius %d is wider than the map: at %d texels "
                      "allowed are 0 to %d",
                      settings->radius, side, (side - 1) / 2);
        }
    }
}

int blur_reach(const BlurSettings *settings)
{
    return (settings->radius + 1) * settings->downsample;
}

char *blur_constants(int radius, const float weights[], int axis)
{
    enum { START_BYTES = 128, WEIGHT_BYTES = 20 };
    int width = 2 * radius + 1;
    size_t bytes = START_BYTES + WEIGHT_BYTES * (size_t)width;
    char *text = allocate(bytes, 1);
    size_t end = (size_t)snprintf(text, bytes,
                                  "const ivec2 axis = ivec2(%d, %d);"
                                  "const int radius = %d;"
                                  "const float weights[%d] = float[](",
                                  1 - axis, axis, radius, width);
    for (int i = 0; i < width; i++) {
        end += (size_t)snprintf(text + end, bytes - end, "%s%.9g",
                                i == 0 ? "" : ", ", (double)weights[i]);
    }
    snprintf(text + end, bytes - end, ");");
    return text;
}

// A box: every texel has the same weight.
static Program *box_program(Frame *frame, int radius, int axis)
{
    static const char *const files[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step4_blur/shaders/map_texel.glsl", "step4_blur/shaders/blur.frag",
        NULL};
    int width = 2 * radius + 1;
    float *weights = allocate((size_t)width, sizeof *weights);
    for (int i = 0; i < width; i++) {
        weights[i] = (float)(1.0 / width);
    }
    char *constants = blur_constants(radius, weights, axis);
    Program *program = gl_program(&frame->shaders, constants, files);
    free(constants);
    free(weights);
    return program;
}

static Program *downsample_program(Frame *frame, int factor)
{
    static const char *const files[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step4_blur/shaders/map_texel.glsl",
        "step4_blur/shaders/downsample.frag", NULL};
    char constants[32];
    snprintf(constants, sizeof constants, "const int factor = %d;", factor);
    return gl_program(&frame->shaders, constants, files);
}

void blur_create(Blur *blur, Frame *frame, const BlurSettings *settings,
                 Target *moments)
{
    static const char *const names[] = {"blur along u", "blur along v"};
    Target *source = moments;
    if (settings->downsample > 1) {
        blur->downsample = downsample_program(frame, settings->downsample);
        blur->small =
            target_reading(source, "downsampling", settings->downsample);
        blur->small.why = "--downsample";
        target_add(&frame->targets, &blur->small);
        source = &blur->small;
    }
    for (int axis = 0; axis < 2 && settings->radius > 0; axis++) {
        Target *pass = &blur->passes[axis];
        blur->programs[axis] = box_program(frame, settings->radius, axis);
        *pass = target_reading(source, names[axis], 1);
        pass->why = "by fragments";
        pass->reach[axis] = settings->radius;
        target_add(&frame->targets, pass);
        source = pass;
    }
    blur->result = target_alias(source);
    blur->result.file = "blurred";
    blur->result.looked_up = 1; // between 2 x 2 texels
    target_add(&frame->targets, &blur->result);
}

void blur_apply(Blur *blur, const Frame *frame)
{
    if (blur->downsample != NULL) {
        frame_filter(frame, blur->downsample, &blur->small);
    }
    for (int axis = 0; axis < 2 && blur->programs[0] != NULL; axis++) {
        frame_filter(frame, blur->programs[axis], &blur->passes[axis]);
    }
}
