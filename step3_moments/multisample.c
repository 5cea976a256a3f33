#include "step3_moments/multisample.h"

#include <stdio.h>  // snprintf
#include <stdlib.h> // free

#include "step1_shadowmap/base/system/die.h"    // allocate, die_usage
#include "step1_shadowmap/base/picture/dump.h"  // dump_image
#include "step1_shadowmap/base/system/memory.h" // memory_check

// Textures and renderbuffers have a limit each, and ours has both.
static void check_limit(int samples)
{
    GLint of_textures = 0, of_buffers = 0;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &of_textures);
    glGetIntegerv(GL_MAX_SAMPLES, &of_buffers);
    int limit = of_textures < of_buffers ? of_textures : of_buffers;
    if (samples > limit) {
        die_usage("--msaa %d is over this driver's limit of %d samples",
                  samples, limit);
    }
}

// A driver may make more samples than were asked for: which it can make, only
// the texture says.
static GLuint create_texture(int samples, GLenum format, int width, int height)
{
    GLenum target = GL_TEXTURE_2D_MULTISAMPLE;
    GLuint texture;
    GLint made = 0;
    glGenTextures(1, &texture);
    glBindTexture(target, texture);
    glTexImage2DMultisample(target, samples, format, width, height, GL_TRUE);
    glGetTexLevelParameteriv(target, 0, GL_TEXTURE_SAMPLES, &made);
    if (made != samples) {
        die_usage("--msaa %d: this driver makes %d samples of it: give %d, or "
                  "drop --msaa",
                  samples, made, made);
    }
    return texture;
}

static GLuint create_depth_buffer(int samples, int width, int height)
{
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples,
                                     GL_DEPTH_COMPONENT32F, width, height);
    return buffer;
}

Multisample multisample_create(Program resolve, int samples, GLenum format,
                               int width, int height)
{
    check_limit(samples);
    Multisample m = {.resolve = resolve, .samples = samples, .format = format};
    m.bytes = (size_t)samples * (size_t)width * (size_t)height *
              (gl_texel_bytes(format) + gl_texel_bytes(GL_DEPTH_COMPONENT32F));
    memory_check(m.bytes, "%d samples of %dx%d texels", samples, width, height);
    m.texture = create_texture(samples, format, width, height);
    m.depth_buffer = create_depth_buffer(samples, width, height);
    glGenFramebuffers(1, &m.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, m.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                           GL_TEXTURE_2D_MULTISAMPLE, m.texture, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                              GL_RENDERBUFFER, m.depth_buffer);
    gl_check_framebuffer("of a texel's samples");
    glGenVertexArrays(1, &m.empty_vao);
    return m;
}

static void draw_samples(const Multisample *multisample, const ShadowMap *map,
                         int layer, const Geometry *geometry,
                         const MapPlan *plan)
{
    glBindFramebuffer(GL_FRAMEBUFFER, multisample->framebuffer);
    shadow_map_draw_layer(map, layer, geometry, plan);
}

// Draws into a framebuffer of one sample per texel what a program makes of all.
static void draw_texels(const Multisample *multisample, const Program *program,
                        GLuint framebuffer)
{
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glUseProgram(program->id);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, multisample->texture);
    glUniform1i(glGetUniformLocation(program->id, "samples"), 0);
    gl_draw_fullscreen(multisample->empty_vao);
}

// The samples are drawn with a depth each; then the texels, from all samples.
static Touched touched_by(const Multisample *multisample, size_t texels)
{
    size_t samples = (size_t)multisample->samples;
    size_t bytes = gl_texel_bytes(multisample->format);
    Touched touched = {0, 0};
    touch(&touched, samples * texels,
          bytes + gl_texel_bytes(GL_DEPTH_COMPONENT32F));
    touch(&touched, texels, bytes + samples * bytes);
    return touched;
}

Touched multisample_draw(const Multisample *multisample, const ShadowMap *map,
                         const Geometry *geometry, const MapPlan *plan)
{
    const Program *resolve = &multisample->resolve;
    for (int layer = 0; layer < map->layers; layer++) {
        const LayerPlan *part = &plan->layers[layer];
        if (!part->draw) {
            continue;
        }
        draw_samples(multisample, map, layer, geometry, plan);
        glUseProgram(resolve->id);
        glUniform1i(glGetUniformLocation(resolve->id, "count"),
                    multisample->samples);
        gl_limit(&part->rect);
        draw_texels(multisample, resolve, map->framebuffers[layer]);
        gl_unlimit();
    }
    return touched_by(multisample, map_plan_texels(plan));
}

static void dump_positions(const Multisample *multisample,
                           const char *directory)
{
    size_t samples = (size_t)multisample->samples;
    float *positions = allocate(samples, 2 * sizeof *positions);
    glBindFramebuffer(GL_FRAMEBUFFER, multisample->framebuffer);
    for (size_t i = 0; i < samples; i++) {
        glGetMultisamplefv(GL_SAMPLE_POSITION, (GLuint)i, &positions[2 * i]);
    }
    dump_image(directory, "sample_positions", positions, (int)samples, 1, 2);
    free(positions);
}

// All samples of the layer that was drawn last.
static void dump_layer(const Multisample *multisample, const Program *program,
                       GLuint framebuffer, const ShadowMap *map, int layer,
                       const char *directory)
{
    for (int i = 0; i < multisample->samples; i++) {
        char name[64];
        snprintf(name, sizeof name, "samples.%d.%d", layer, i);
        glUseProgram(program->id);
        glUniform1i(glGetUniformLocation(program->id, "index"), i);
        draw_texels(multisample, program, framebuffer);
        float *texels = gl_read(framebuffer, 0, map->width, map->height, 2);
        dump_image(directory, name, texels, map->width, map->height, 2);
        free(texels);
    }
}

void multisample_dump(const Multisample *multisample, const ShadowMap *map,
                      const Geometry *geometry, const MapPlan *plan,
                      const char *directory)
{
    const char *const vertex[] = {"step1_shadowmap/shaders/fullscreen.vert",
                                  NULL};
    const char *const fragment[] = {"step3_moments/shaders/one_sample.frag",
                                    NULL};
    Program program = gl_program(multisample->resolve.where, vertex, fragment);
    GLuint texture = gl_texture_array(multisample->format, map->width,
                                      map->height, 1, map->sampling);
    GLuint framebuffer = gl_layer_framebuffer(texture, 0, 0);
    for (int layer = 0; layer < map->layers; layer++) {
        draw_samples(multisample, map, layer, geometry, plan);
        dump_layer(multisample, &program, framebuffer, map, layer, directory);
    }
    dump_positions(multisample, directory);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
    gl_program_destroy(&program);
}

bool multisample_reload(Multisample *multisample)
{
    return gl_program_reload(&multisample->resolve);
}

void multisample_destroy(Multisample *multisample)
{
    glDeleteVertexArrays(1, &multisample->empty_vao);
    glDeleteFramebuffers(1, &multisample->framebuffer);
    glDeleteRenderbuffers(1, &multisample->depth_buffer);
    glDeleteTextures(1, &multisample->texture);
    gl_program_destroy(&multisample->resolve);
    *multisample = (Multisample){0};
}
