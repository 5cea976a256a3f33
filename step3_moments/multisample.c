#include "step3_moments/multisample.h"

#include <stdio.h>  // snprintf
#include <stdlib.h> // free

#include "step1_shadowmap/base/picture/dump.h" // dump_image
#include "step1_shadowmap/base/system/die.h"   // allocate

static Program *create_program(Shaders *shaders,
                               const MomentsSettings *settings)
{
    static const char *const vertex[] = {
        "step1_shadowmap/shaders/fullscreen.vert", NULL};
    const char *const fragment[] = {moments_merge_shader(settings),
                                    moments_store_shader(settings),
                                    "step3_moments/shaders/resolve.frag", NULL};
    return gl_program(shaders, NULL, vertex, fragment);
}

void multisample_create(Moments *moments, Frame *frame)
{
    Target *samples = &moments->samples;
    *samples = frame_map(frame, "moments", moments->target.formats[0],
                         moments->target.sampling);
    samples->kind = TARGET_SAMPLES;
    samples->samples = moments->settings->msaa;
    samples->depth = true;
    target_add(&frame->targets, samples);
    moments->target.pass = "samples to moments";
    moments->target.why = "--msaa";
    moments->target.reads = samples;
    moments->target.scale = 1;
    moments->resolve = create_program(&frame->shaders, moments->settings);
}

// Draws what a program in use makes of all samples of a texel.
static void draw_texels(const Moments *moments, const Frame *frame,
                        GLuint program)
{
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, moments->samples.textures[0]);
    glUniform1i(glGetUniformLocation(program, "samples"), 0);
    gl_draw_fullscreen(frame->empty_vao);
}

// All samples of the layer that was drawn last.
static void dump_layer(const Moments *moments, const Frame *frame, int layer)
{
    static const char *const vertex[] = {
        "step1_shadowmap/shaders/fullscreen.vert", NULL};
    static const char *const fragment[] = {
        "step3_moments/shaders/one_sample.frag", NULL};
    Shaders shaders = {.directory = frame->shaders.directory};
    Targets targets = {.count = 0};
    Target one = frame_map(frame, "one sample", moments->target.formats[0],
                           moments->target.sampling);
    one.layers = 1;
    target_add(&targets, &one);
    GLuint program = gl_use(gl_program(&shaders, NULL, vertex, fragment));
    for (int i = 0; i < moments->samples.samples; i++) {
        char name[64];
        snprintf(name, sizeof name, "samples.%d.%d", layer, i);
        target_begin(&one, 0);
        glUniform1i(glGetUniformLocation(program, "index"), i);
        draw_texels(moments, frame, program);
        float *texels =
            gl_read(one.framebuffers[0], 0, one.width, one.height, 2);
        dump_image(frame->dump, name, texels, one.width, one.height, 2);
        free(texels);
    }
    targets_destroy(&targets);
    gl_destroy_programs(&shaders);
}

void multisample_draw_layer(Moments *moments, const Frame *frame, int layer)
{
    bool drawn = shadow_map_draw_layer(&moments->samples, moments->program,
                                       frame, layer);
    if (drawn && target_begin(&moments->target, layer)) {
        GLuint program = gl_use(moments->resolve);
        glUniform1i(glGetUniformLocation(program, "count"),
                    moments->samples.samples);
        draw_texels(moments, frame, program);
    }
    if (drawn && frame->dump != NULL) {
        dump_layer(moments, frame, layer);
    }
}

void multisample_dump_positions(const Moments *moments, const char *directory)
{
    size_t samples = (size_t)moments->samples.samples;
    float *positions = allocate(samples, 2 * sizeof *positions);
    glBindFramebuffer(GL_FRAMEBUFFER, moments->samples.framebuffers[0]);
    for (size_t i = 0; i < samples; i++) {
        glGetMultisamplefv(GL_SAMPLE_POSITION, (GLuint)i, &positions[2 * i]);
    }
    dump_image(directory, "sample_positions", positions, (int)samples, 1, 2);
    free(positions);
}
