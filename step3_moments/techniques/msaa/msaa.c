// --msaa: several samples per texel while the map is drawn, then their moments.
#include <stdio.h>  // snprintf
#include <stdlib.h> // free

#include "step1_shadowmap/base/picture/dump.h" // dump_image
#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h"        // allocate
#include "step3_moments/moments.h"                  // moments_shaders
#include "step3_moments/techniques/shared/shared.h" // moments_merged

static struct {
    int count; // samples per texel
} settings = {1};

static struct {
    Program *program; // of the samples
    Program *resolve;
    Target samples; // of one layer after the other
    Target texels;  // their moments, in place of the lesson's
} state;

static const Option options[] = {
    {.name = "msaa",
     .kind = OPTION_INTEGER,
     .minimum = 1,
     .maximum = 64,
     .argument = "N",
     .help = "samples per texel while the map is drawn, of which it keeps the "
             "moments"},
    {0},
};

// A fragment has its position at a place that its triangle covers.
static bool prepare(Frame *frame)
{
    static const char *const in[] = {
        "step3_moments/techniques/msaa/centroid_in.glsl", NULL};
    static const char *const out[] = {
        "step3_moments/techniques/msaa/centroid_out.glsl", NULL};
    static const char *const vertex[] = {
        "step3_moments/techniques/shared/centre_out.glsl",
        "step3_moments/techniques/shared/map_handing.vert", NULL};
    Shaders *shaders = &frame->shaders;
    if (settings.count == 1) {
        return false;
    }
    gl_put_instead(shaders, "step3_moments/shaders/moments.frag",
                   moments_merged);
    gl_put_instead(shaders, "step3_moments/techniques/shared/position.glsl",
                   in);
    gl_put_instead(shaders, "step3_moments/techniques/shared/centre_out.glsl",
                   out);
    gl_put_instead(shaders, "step1_shadowmap/shaders/map.vert", vertex);
    frame->lookups.spread = 0; // it is not shown that a lone plane stays lit
    return true;
}

// The moments of the samples take the place of the lesson's. When the samples
// are drawn, a number of them that this driver does not have is refused
// (status 2).
static void create(Frame *frame, Picture *picture)
{
    static const char *const resolve[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step3_moments/techniques/shared/merge_raw.glsl",
        "step3_moments/techniques/shared/store_float.glsl",
        "step3_moments/techniques/msaa/resolve.frag", NULL};
    Target *moments = targets_find(&frame->targets, "moments");
    (void)picture;
    state.program = gl_program(&frame->shaders, NULL, moments_shaders);
    state.resolve = gl_program(&frame->shaders, NULL, resolve);
    state.samples =
        frame_map(frame, "moments", moments->formats[0], moments->sampling);
    state.samples.kind = TARGET_SAMPLES;
    state.samples.samples = settings.count;
    state.samples.depth = true;
    state.texels = frame_map(frame, "samples to moments", moments->formats[0],
                             moments->sampling);
    state.texels.why = "--msaa";
    state.texels.reads = &state.samples;
    state.texels.scale = 1;
    target_add_before(&frame->targets, &state.samples, moments);
    target_add_before(&frame->targets, &state.texels, moments);
    target_take_place(moments, &state.texels);
}

// Draws what a program in use makes of all samples of a texel.
static void draw_texels(const Frame *frame, GLuint program)
{
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, state.samples.textures[0]);
    glUniform1i(glGetUniformLocation(program, "samples"), 0);
    gl_draw_fullscreen(frame->empty_vao);
}

// All samples of the layer that was drawn last.
static void dump_layer(const Frame *frame, int layer)
{
    static const char *const files[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step3_moments/techniques/msaa/one_sample.frag", NULL};
    Shaders shaders = {.directory = frame->shaders.directory};
    Targets targets = {.count = 0};
    Target one = frame_map(frame, "one sample", state.texels.formats[0],
                           state.texels.sampling);
    one.layers = 1;
    target_add(&targets, &one);
    GLuint program = gl_use(gl_program(&shaders, NULL, files));
    for (int i = 0; i < state.samples.samples; i++) {
        char name[64];
        snprintf(name, sizeof name, "samples.%d.%d", layer, i);
        target_begin(&one, 0);
        glUniform1i(glGetUniformLocation(program, "index"), i);
        draw_texels(frame, program);
        float *texels =
            gl_read(one.framebuffers[0], 0, one.width, one.height, 2);
        dump_image(frame->dump, name, texels, one.width, one.height, 2);
        free(texels);
    }
    targets_destroy(&targets);
    gl_destroy_programs(&shaders);
}

// With --dump sample S of layer L becomes samples.L.S.exr.
static void draw_layer(const Frame *frame, int layer)
{
    shadow_map_draw_layer(&state.samples, state.program, frame, layer);
    if (!target_begin(&state.texels, layer)) {
        return;
    }
    GLuint program = gl_use(state.resolve);
    glUniform1i(glGetUniformLocation(program, "count"), settings.count);
    draw_texels(frame, program);
    if (frame->dump != NULL) {
        dump_layer(frame, layer);
    }
}

// sample_positions.exr, of one row: where each sample lies in a texel, x and y
// in [0, 1], y upwards.
static void dump_positions(const char *directory)
{
    size_t count = (size_t)settings.count;
    float *positions = allocate(count, 2 * sizeof *positions);
    glBindFramebuffer(GL_FRAMEBUFFER, state.samples.framebuffers[0]);
    for (size_t i = 0; i < count; i++) {
        glGetMultisamplefv(GL_SAMPLE_POSITION, (GLuint)i, &positions[2 * i]);
    }
    dump_image(directory, "sample_positions", positions, settings.count, 1, 2);
    free(positions);
}

static void before(const Frame *frame)
{
    for (int layer = 0; layer < state.texels.layers; layer++) {
        draw_layer(frame, layer);
    }
    if (frame->dump != NULL) {
        dump_positions(frame->dump);
    }
}

const Technique moments_msaa = {.options = options,
                                .settings = &settings,
                                .prepare = prepare,
                                .create = create,
                                .before = before};
