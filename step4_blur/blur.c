#include "step4_blur/blur.h"

#include <math.h>   // exp
#include <stdlib.h> // free
#include <string.h> // strcmp

#include "step1_shadowmap/base/die.h" // allocate, die_usage

// The published filter of 7 taps.
enum { BINOMIAL_RADIUS = 3 };

const Option blur_options[] = {
    {.name = "blur",
     .kind = OPTION_CHOICE,
     .offset = offsetof(BlurSettings, kernel),
     .choices = "none,box,gaussian,binomial",
     .help = "the filter's kernel; the binomial one is 7 texels wide"},
    {.name = "radius",
     .kind = OPTION_INTEGER,
     .offset = offsetof(BlurSettings, radius),
     .minimum = 0,
     .maximum = 1024,
     .argument = "N",
     .help = "the filter is 2 N + 1 texels wide, of the map it runs on"},
    {.name = "downsample",
     .kind = OPTION_INTEGER,
     .offset = offsetof(BlurSettings, downsample),
     .minimum = 1,
     .maximum = 16,
     .argument = "N",
     .help = "average N x N texels into one before the blur"},
    {0},
};

BlurSettings blur_settings(void)
{
    return (BlurSettings){.kernel = "box", .radius = 3, .downsample = 1};
}

static int used_radius(const BlurSettings *settings)
{
    return strcmp(settings->kernel, "none") == 0 ? 0 : settings->radius;
}

void blur_settings_check(const BlurSettings *settings, const int map_size[2],
                         const OptionTable tables[])
{
    if (used_radius(settings) == 0 && settings->radius > 0 &&
        options_given(tables, "radius")) {
        die_usage("--radius %d contradicts --blur none: drop one of them",
                  settings->radius);
    }
    if (strcmp(settings->kernel, "binomial") == 0 &&
        settings->radius != BINOMIAL_RADIUS) {
        die_usage("--radius %d contradicts --blur binomial, whose radius is "
                  "%d: drop one of them",
                  settings->radius, BINOMIAL_RADIUS);
    }
    for (int axis = 0; axis < 2; axis++) {
        int side = map_size[axis] / settings->downsample;
        if (map_size[axis] % settings->downsample != 0) {
            die_usage("--downsample %d does not divide --map-size %dx%d",
                      settings->downsample, map_size[0], map_size[1]);
        }
        if (used_radius(settings) > 0 && 2 * used_radius(settings) + 1 > side) {
            die_usage("--radius %d is wider than the map: at %d texels "
                      "allowed are 0 to %d",
                      settings->radius, side, (side - 1) / 2);
        }
    }
}

int blur_reach(const BlurSettings *settings)
{
    return (used_radius(settings) + 1) * settings->downsample;
}

static BlurTarget create_target(Blur *blur, GLenum format)
{
    blur->bytes += (size_t)blur->width * (size_t)blur->height *
                   (size_t)blur->layers * gl_texel_bytes(format);
    BlurTarget target = {.texture =
                             gl_texture_array(format, blur->width, blur->height,
                                              blur->layers, GL_LINEAR)};
    for (int layer = 0; layer < blur->layers; layer++) {
        target.framebuffers[layer] =
            gl_layer_framebuffer(target.texture, layer, 0);
    }
    return target;
}

static double kernel_weight(const char *name, int radius, int offset)
{
    double weight = 1; // box
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

void blur_weights(const char *name, int radius, float weights[])
{
    double sum = 0;
    for (int i = -radius; i <= radius; i++) {
        sum += kernel_weight(name, radius, i);
    }
    for (int i = -radius; i <= radius; i++) {
        weights[i + radius] = (float)(kernel_weight(name, radius, i) / sum);
    }
}

static GLuint create_weights(const BlurSettings *settings)
{
    int width = 2 * settings->radius + 1;
    float *weights = allocate((size_t)width, sizeof *weights);
    blur_weights(settings->kernel, settings->radius, weights);
    GLuint texture = gl_texture(GL_R32F, width, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, 1, GL_RED, GL_FLOAT,
                    weights);
    free(weights);
    return texture;
}

static Program create_program(ShaderFiles files, const char *fragment_shader)
{
    const char *vertex[] = {"step1_shadowmap/shaders/fullscreen.vert", NULL};
    const char *fragment[] = {"step4_blur/shaders/map_texel.glsl",
                              fragment_shader, NULL};
    return gl_program(files, vertex, fragment);
}

Blur blur_create(ShaderFiles files, const BlurSettings *settings,
                 const ShadowMap *moments, GLenum format)
{
    Blur blur = {.factor = settings->downsample,
                 .radius = used_radius(settings),
                 .width = moments->width / settings->downsample,
                 .height = moments->height / settings->downsample,
                 .layers = moments->layers};
    glGenVertexArrays(1, &blur.empty_vao);
    if (blur.factor > 1) {
        blur.downsample_program =
            create_program(files, "step4_blur/shaders/downsample.frag");
        blur.small = create_target(&blur, format);
    }
    if (blur.radius > 0) {
        blur.blur_program =
            create_program(files, "step4_blur/shaders/blur.frag");
        blur.weights = create_weights(settings);
        blur.horizontal = create_target(&blur, format);
        blur.vertical = create_target(&blur, format);
    }
    return blur;
}

// Draws every layer of the target from the same layer of the source.
static void draw_layers(const Blur *blur, GLuint program, GLuint source,
                        const BlurTarget *target)
{
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, source);
    glUniform1i(glGetUniformLocation(program, "map"), 0);
    for (int layer = 0; layer < blur->layers; layer++) {
        glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffers[layer]);
        glUniform1i(glGetUniformLocation(program, "layer"), layer);
        gl_draw_fullscreen(blur->empty_vao);
    }
}

static void downsample(const Blur *blur, GLuint source)
{
    GLuint program = blur->downsample_program.id;
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "factor"), blur->factor);
    draw_layers(blur, program, source, &blur->small);
}

static void blur_axes(const Blur *blur, GLuint source)
{
    GLuint program = blur->blur_program.id;
    GLint axis = glGetUniformLocation(program, "axis");
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "radius"), blur->radius);
    glUniform1i(glGetUniformLocation(program, "weights"), 1);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, blur->weights);
    glUniform2i(axis, 1, 0);
    draw_layers(blur, program, source, &blur->horizontal);
    glUniform2i(axis, 0, 1);
    draw_layers(blur, program, blur->horizontal.texture, &blur->vertical);
}

GLuint blur_apply(const Blur *blur, const ShadowMap *moments)
{
    GLuint result = moments->texture;
    glDisable(GL_DEPTH_TEST);
    glViewport(0, 0, blur->width, blur->height);
    if (blur->factor > 1) {
        downsample(blur, result);
        result = blur->small.texture;
    }
    if (blur->radius > 0) {
        blur_axes(blur, result);
        result = blur->vertical.texture;
    }
    return result;
}

bool blur_reload(Blur *blur)
{
    return gl_program_reload(&blur->downsample_program) &&
           gl_program_reload(&blur->blur_program);
}

static void destroy_target(const Blur *blur, BlurTarget *target)
{
    glDeleteFramebuffers(blur->layers, target->framebuffers);
    glDeleteTextures(1, &target->texture);
}

void blur_destroy(Blur *blur)
{
    // The name 0, of what was never created, is ignored.
    destroy_target(blur, &blur->vertical);
    destroy_target(blur, &blur->horizontal);
    destroy_target(blur, &blur->small);
    glDeleteTextures(1, &blur->weights);
    gl_program_destroy(&blur->blur_program);
    gl_program_destroy(&blur->downsample_program);
    glDeleteVertexArrays(1, &blur->empty_vao);
    *blur = (Blur){.width = 0};
}
