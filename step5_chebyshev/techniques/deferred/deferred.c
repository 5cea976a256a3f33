// --deferred: first what each pixel shows, then its light. A pixel is shaded
// once, however many surfaces were drawn over it. The same picture to the last
// bit where the driver computes both alike.
#include "step1_shadowmap/base/picture/picture.h" // Picture
#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/techniques/shared/footprint.h"

static struct {
    bool asked; // what each pixel shows first, then its light
} settings;

// The G-buffer: position relative to the camera, normal and albedo, and where
// the picture's lookup needs the footprint the position's two derivatives. All
// are 32-bit floats. A position from the depth buffer would be cheaper to keep,
// but at view depth z its error is near 2^-24 z^2 / near, that of a stored
// float 2^-24 z: t, and with it the picture, would be another one.
static struct {
    Target target;
    Program *program;
    int count; // of the textures
} state;

static const Option options[] = {
    {.name = "deferred",
     .kind = OPTION_FLAG,
     .help =
         "store what each pixel shows in a G-buffer, then shade every pixel "
         "once"},
    {0},
};

enum { MAX_TEXTURES = 5 };

// What the second pass calls them. The last two are there with a footprint.
static const char *const names[MAX_TEXTURES] = {
    "stored_position", "stored_normal", "stored_albedo", "stored_right",
    "stored_above"};

// The first of their texture units; those below are the lookup's.
enum { FIRST_UNIT = 8 };

static bool prepare(Frame *frame)
{
    (void)frame;
    return settings.asked;
}

static Program *create_program(Frame *frame, bool footprint)
{
    static const char *const plain[] = {
        "step1_shadowmap/shaders/scene.vert",
        "step1_shadowmap/base/picture/shaders/surface.glsl",
        "step5_chebyshev/techniques/deferred/gbuffer_steps_nothing.glsl",
        "step5_chebyshev/techniques/deferred/gbuffer.frag", NULL};
    static const char *const stepped[] = {
        "step1_shadowmap/shaders/scene.vert",
        "step1_shadowmap/base/picture/shaders/surface.glsl",
        "step1_shadowmap/techniques/shared/steps.glsl",
        "step5_chebyshev/techniques/deferred/gbuffer_steps.glsl",
        "step5_chebyshev/techniques/deferred/gbuffer.frag",
        NULL};
    return gl_program(&frame->shaders, NULL, footprint ? stepped : plain);
}

// Where the picture's program finds what a pixel shows, once that of the
// G-buffer has the lesson's.
static void put_stored(Shaders *shaders)
{
    static const char *const vertex[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert", NULL};
    static const char *const surface[] = {
        "step5_chebyshev/techniques/deferred/surface_stored.glsl", NULL};
    static const char *const steps[] = {
        "step5_chebyshev/techniques/deferred/steps_stored.glsl", NULL};
    gl_put_instead(shaders, "step1_shadowmap/shaders/scene.vert", vertex);
    gl_put_instead(shaders, "step1_shadowmap/base/picture/shaders/surface.glsl",
                   surface);
    gl_put_instead(shaders, "step1_shadowmap/techniques/shared/steps.glsl",
                   steps);
}

static void create(Frame *frame, Picture *picture)
{
    state.count = map_footprint_is_used() ? 5 : 3;
    state.program = create_program(frame, map_footprint_is_used());
    put_stored(&frame->shaders);
    state.target = (Target){.pass = "G-buffer",
                            .why = "--deferred",
                            .kind = TARGET_PICTURE,
                            .width = picture->target.width,
                            .height = picture->target.height,
                            .layers = 1,
                            .depth_of = &picture->target};
    for (int i = 0; i < state.count; i++) {
        state.target.formats[i] = GL_RGBA32F;
    }
    picture->target.read_bytes = target_texel_bytes(&state.target);
    target_add(&frame->targets, &state.target);
}

// Nothing is cleared but the depth: what was not drawn is not read.
static void fill(const Frame *frame)
{
    const Views *views = &frame->views;
    target_begin(&state.target, 0);
    view_set_matrix(gl_use(state.program), "clip_from_relative",
                    views->clip_from_relative);
    geometry_draw(&frame->geometry, &frame->scene, &views->seen, views->origin);
}

// A triangle at far depth passes where something nearer was drawn: elsewhere
// the picture keeps its background.
static void shade(const Frame *frame, const Picture *picture)
{
    fill(frame);
    GLuint program = gl_use(picture->program);
    glBindFramebuffer(GL_FRAMEBUFFER, picture->target.framebuffers[0]);
    for (int i = 0; i < state.count; i++) {
        glActiveTexture(GL_TEXTURE0 + FIRST_UNIT + (GLenum)i);
        glBindTexture(GL_TEXTURE_2D, state.target.textures[i]);
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

const Technique chebyshev_deferred = {.options = options,
                                      .settings = &settings,
                                      .prepare = prepare,
                                      .create = create,
                                      .shade = shade};
