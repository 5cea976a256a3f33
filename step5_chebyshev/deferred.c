#include "step5_chebyshev/deferred.h"

static const PictureSource stored = {
    .vertex = "step1_shadowmap/shaders/fullscreen.vert",
    .surface = "step5_chebyshev/shaders/surface_stored.glsl",
    .steps = "step5_chebyshev/shaders/steps_stored.glsl",
};

enum { MAX_TEXTURES = 5 };

// What the second pass calls them. The last two are there with a footprint.
static const char *const names[MAX_TEXTURES] = {
    "stored_position", "stored_normal", "stored_albedo", "stored_right",
    "stored_above"};

// The first of their texture units; those below are the lookup's.
enum { FIRST_UNIT = 8 };

const PictureSource *deferred_source(bool deferred)
{
    return deferred ? &stored : &picture_drawn;
}

static Program *create_program(Shaders *shaders, bool footprint)
{
    const char *vertex[] = {picture_drawn.vertex, NULL};
    const char *plain[] = {picture_drawn.surface,
                           "step5_chebyshev/shaders/gbuffer_steps_nothing.glsl",
                           "step5_chebyshev/shaders/gbuffer.frag", NULL};
    const char *stepped[] = {picture_drawn.surface, picture_drawn.steps,
                             "step5_chebyshev/shaders/gbuffer_steps.glsl",
                             "step5_chebyshev/shaders/gbuffer.frag", NULL};
    return gl_program(shaders, NULL, vertex, footprint ? stepped : plain);
}

static void create_target(Deferred *deferred, Picture *picture)
{
    deferred->target = (Target){.pass = "G-buffer",
                                .why = "--deferred",
                                .kind = TARGET_PICTURE,
                                .width = picture->target.width,
                                .height = picture->target.height,
                                .layers = 1,
                                .depth_of = &picture->target};
    for (int i = 0; i < deferred->count; i++) {
        deferred->target.formats[i] = GL_RGBA32F;
    }
    picture->target.read_bytes = target_texel_bytes(&deferred->target);
}

void deferred_create(Deferred *deferred, Frame *frame, bool asked_for,
                     Picture *picture)
{
    deferred->target = (Target){.pass = "G-buffer",
                                .why = "surfaces are shaded as they are drawn",
                                .kind = TARGET_NOTHING,
                                .idle = true};
    if (asked_for) {
        deferred->count = picture->footprint ? 5 : 3;
        deferred->program = create_program(&frame->shaders, picture->footprint);
        create_target(deferred, picture);
    }
    target_add(&frame->targets, &deferred->target);
}

// Nothing is cleared but the depth: what was not drawn is not read.
static void fill(Deferred *deferred, const Frame *frame)
{
    const Views *views = &frame->views;
    target_begin(&deferred->target, 0);
    view_set_matrix(gl_use(deferred->program), "clip_from_relative",
                    views->clip_from_relative);
    geometry_draw(&frame->geometry, &frame->scene, &views->seen, views->origin);
}

// A triangle at far depth passes where something nearer was drawn: elsewhere
// the picture keeps its background.
static void shade(const Deferred *deferred, const Picture *picture,
                  const Frame *frame)
{
    GLuint program = gl_use(picture->program);
    glBindFramebuffer(GL_FRAMEBUFFER, picture->target.framebuffers[0]);
    for (int i = 0; i < deferred->count; i++) {
        glActiveTexture(GL_TEXTURE0 + FIRST_UNIT + (GLenum)i);
        glBindTexture(GL_TEXTURE_2D, deferred->target.textures[i]);
        glUniform1i(glGetUniformLocation(program, names[i]), FIRST_UNIT + i);
    }
    glActiveTexture(GL_TEXTURE0);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glDepthRange(1, 1);
    gl_draw_fullscreen(frame->empty_vao);
    glDepthRange(0, 1);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

void deferred_draw(Deferred *deferred, Picture *picture, const Frame *frame)
{
    if (deferred->program == NULL) {
        picture_draw(picture, frame);
    } else if (picture->drawing) {
        fill(deferred, frame);
        shade(deferred, picture, frame);
        picture_end(picture, frame);
    }
}
