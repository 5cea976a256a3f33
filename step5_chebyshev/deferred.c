#include "step5_chebyshev/deferred.h"

static const SceneSource stored = {
    .vertex = "step1_shadowmap/shaders/fullscreen.vert",
    .surface = "step5_chebyshev/shaders/surface_stored.glsl",
    .steps = "step5_chebyshev/shaders/steps_stored.glsl",
};

// What the second pass calls them. The last two are there with a footprint.
static const char *const names[DEFERRED_TEXTURES] = {
    "stored_position", "stored_normal", "stored_albedo", "stored_right",
    "stored_above"};

// The first of their texture units; those below are the lookup's.
enum { FIRST_UNIT = 8 };

const SceneSource *deferred_source(bool deferred)
{
    return deferred ? &stored : &scene_source_drawn;
}

static Program create_program(ShaderFiles files, bool footprint)
{
    const char *vertex[] = {scene_source_drawn.vertex, NULL};
    const char *plain[] = {scene_source_drawn.surface,
                           "step5_chebyshev/shaders/gbuffer_steps_nothing.glsl",
                           "step5_chebyshev/shaders/gbuffer.frag", NULL};
    const char *stepped[] = {scene_source_drawn.surface,
                             scene_source_drawn.steps,
                             "step5_chebyshev/shaders/gbuffer_steps.glsl",
                             "step5_chebyshev/shaders/gbuffer.frag", NULL};
    return gl_program(files, vertex, footprint ? stepped : plain);
}

static void create_framebuffer(Deferred *deferred, const SceneDraw *picture)
{
    GLenum buffers[DEFERRED_TEXTURES];
    glGenFramebuffers(1, &deferred->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, deferred->framebuffer);
    for (int i = 0; i < deferred->count; i++) {
        deferred->textures[i] =
            gl_texture(GL_RGBA32F, picture->width, picture->height);
        buffers[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        glFramebufferTexture2D(GL_FRAMEBUFFER, buffers[i], GL_TEXTURE_2D,
                               deferred->textures[i], 0);
    }
    glDrawBuffers(deferred->count, buffers);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                              GL_RENDERBUFFER, picture->depth_buffer);
    gl_check_framebuffer("of the G-buffer");
}

Deferred deferred_create(bool asked_for, const BaseSettings *base,
                         SceneDraw *picture)
{
    if (!asked_for) {
        return (Deferred){.count = 0};
    }
    Deferred deferred = {.count = picture->footprint ? 5 : 3};
    deferred.program =
        create_program(base_shader_files(base), picture->footprint);
    create_framebuffer(&deferred, picture);
    for (int i = 0; i < deferred.count; i++) { // written, then read
        touch(&picture->touched,
              (size_t)picture->width * (size_t)picture->height,
              2 * gl_texel_bytes(GL_RGBA32F));
    }
    glGenVertexArrays(1, &deferred.empty_vao);
    return deferred;
}

// Nothing is cleared but the depth: what was not drawn is not read.
static void fill(const Deferred *deferred, const Scene *scene,
                 const Geometry *geometry, const Views *views)
{
    glBindFramebuffer(GL_FRAMEBUFFER, deferred->framebuffer);
    glUseProgram(deferred->program.id);
    view_set_matrix(deferred->program.id, "clip_from_relative",
                    views->clip_from_relative);
    geometry_draw(geometry, scene, &views->seen, views->origin);
}

// A triangle at far depth passes where something nearer was drawn: elsewhere
// the picture keeps its background.
static void shade(const Deferred *deferred, const SceneDraw *picture)
{
    glBindFramebuffer(GL_FRAMEBUFFER, picture->framebuffer);
    glUseProgram(picture->program.id);
    for (int i = 0; i < deferred->count; i++) {
        glActiveTexture(GL_TEXTURE0 + FIRST_UNIT + (GLenum)i);
        glBindTexture(GL_TEXTURE_2D, deferred->textures[i]);
        glUniform1i(glGetUniformLocation(picture->program.id, names[i]),
                    FIRST_UNIT + i);
    }
    glActiveTexture(GL_TEXTURE0);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glDepthRange(1, 1);
    gl_draw_fullscreen(deferred->empty_vao);
    glDepthRange(0, 1);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

void deferred_draw(const Deferred *deferred, const SceneDraw *picture,
                   const Scene *scene, const Geometry *geometry,
                   const Views *views, GLuint map)
{
    scene_draw_begin(picture, scene, views, map);
    if (deferred->program.id == 0) {
        geometry_draw(geometry, scene, &views->seen, views->origin);
    } else {
        fill(deferred, scene, geometry, views);
        shade(deferred, picture);
    }
    scene_draw_end(picture);
}

bool deferred_reload(Deferred *deferred)
{
    return gl_program_reload(&deferred->program);
}

void deferred_destroy(Deferred *deferred)
{
    // The name 0, of what was never created, is ignored.
    glDeleteVertexArrays(1, &deferred->empty_vao);
    glDeleteTextures(DEFERRED_TEXTURES, deferred->textures);
    glDeleteFramebuffers(1, &deferred->framebuffer);
    gl_program_destroy(&deferred->program);
    *deferred = (Deferred){.count = 0};
}
