#include "step1_shadowmap/base/picture/scene_draw.h"

#include <math.h>   // sin
#include <stdlib.h> // free
#include <string.h> // memcpy, strcmp

#include "step1_shadowmap/base/system/die.h"   // die
#include "step1_shadowmap/base/picture/dump.h" // dump_image
#include "step1_shadowmap/base/files/image.h"  // image_write

enum { MAX_FILES = PROGRAM_MAX_FILES };

const char scene_draw_footprint[] = "step1_shadowmap/shaders/footprint.glsl";

const SceneSource scene_source_drawn = {
    .vertex = "step1_shadowmap/shaders/scene.vert",
    .surface = "step1_shadowmap/shaders/surface.glsl",
    .steps = "step1_shadowmap/shaders/steps.glsl",
};

// A spot loses its brightness between this part of its cone and the edge.
#define BRIGHT_PART 0.8

// The places in the list below that need a name.
enum { OUTPUT_IMAGE = 0, OUTPUT_FOOTPRINT = 5, OUTPUT_HANDOVER = 6 };

// What the fragment shader writes, in the order of its output locations.
static const struct {
    const char *name;
    GLenum format;
    int channels;
    float empty[4]; // where the picture shows no object
} outputs[SCENE_DRAW_OUTPUTS] = {
    {"image", GL_RGBA32F, 3, {0, 0, 0, 0}}, // the scene's background
    {"receiver", GL_RGBA32F, 4, {0, 0, 0, -1}},
    {"position", GL_RGBA32F, 3, {0, 0, 0, 0}},
    {"normal", GL_RGBA32F, 3, {0, 0, 0, 0}},
    {"visibility", GL_R32F, 1, {1, 1, 1, 1}},
    {"footprint", GL_RGBA32F, 4, {0, 0, 0, 0}}, // where it is used
    {"handover", GL_RGBA32F, 4, {0, 0, 0, 0}},  // of splits
};

static bool uses_footprint(const char *const visibility[])
{
    bool found = false;
    for (int i = 0; visibility[i] != NULL; i++) {
        found = found || strcmp(visibility[i], scene_draw_footprint) == 0;
    }
    return found;
}

// The attachment of each output, or none.
static void choose_outputs(SceneDraw *draw, const BaseSettings *settings)
{
    bool dumped = settings->dump != NULL;
    for (int i = 0; i < SCENE_DRAW_OUTPUTS; i++) {
        bool used = i == OUTPUT_IMAGE || dumped;
        used = used && (i != OUTPUT_FOOTPRINT || draw->footprint);
        used = used && (i != OUTPUT_HANDOVER || settings->splits > 1);
        draw->buffers[i] = used ? GL_COLOR_ATTACHMENT0 + (GLenum)i : GL_NONE;
    }
}

// How a position finds its layer of the map.
static const char *layer_shader(const BaseSettings *settings, LightKind kind)
{
    if (kind == LIGHT_POINT) {
        return "step1_shadowmap/shaders/layer_face.glsl";
    }
    return settings->splits > 1 ? "step1_shadowmap/shaders/layer_split.glsl"
                                : "step1_shadowmap/shaders/layer_only.glsl";
}

static Program create_program(const SceneSource *source,
                              const BaseSettings *settings, LightKind kind,
                              const char *const visibility[])
{
    const char *const vertex[] = {source->vertex, NULL};
    const ShowMode *mode = base_show_mode(settings);
    const char *fragment[MAX_FILES] = {
        source->surface, "step1_shadowmap/shaders/light_depth.glsl",
        settings->depth_shader, layer_shader(settings, kind),
        "step1_shadowmap/shaders/map_coordinates.glsl"};
    int count = 5;
    if (uses_footprint(visibility)) {
        fragment[count++] = source->steps;
    }
    for (int i = 0; visibility[i] != NULL; i++) {
        if (count + 7 > MAX_FILES) {
            die("more than %d shader files", MAX_FILES);
        }
        fragment[count++] = visibility[i];
    }
    if (mode->scale != NULL) {
        fragment[count++] = mode->scale;
    }
    fragment[count++] = mode->shader;
    if (settings->dump != NULL && !uses_footprint(visibility)) {
        fragment[count++] = "step1_shadowmap/shaders/footprint_nothing.glsl";
    }
    fragment[count++] = settings->dump == NULL
                            ? "step1_shadowmap/shaders/dump_nothing.glsl"
                            : "step1_shadowmap/shaders/dump.glsl";
    fragment[count] = "step1_shadowmap/shaders/scene.frag";
    return gl_program(base_shader_files(settings), vertex, fragment);
}

static void create_framebuffer(SceneDraw *draw)
{
    size_t bytes = gl_texel_bytes(GL_DEPTH_COMPONENT32F);
    glGenFramebuffers(1, &draw->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, draw->framebuffer);
    for (int i = 0; i < SCENE_DRAW_OUTPUTS; i++) {
        if (draw->buffers[i] == GL_NONE) {
            continue;
        }
        draw->outputs[i] =
            gl_texture(outputs[i].format, draw->width, draw->height);
        bytes += gl_texel_bytes(outputs[i].format);
        glFramebufferTexture2D(GL_FRAMEBUFFER, draw->buffers[i], GL_TEXTURE_2D,
                               draw->outputs[i], 0);
    }
    draw->depth_buffer = gl_depth_buffer(draw->width, draw->height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                              GL_RENDERBUFFER, draw->depth_buffer);
    gl_check_framebuffer("of the picture");
    touch(&draw->touched, (size_t)draw->width * (size_t)draw->height, bytes);
}

SceneDraw scene_draw_create(const BaseSettings *settings, Facts *facts,
                            const char *const visibility[])
{
    return scene_draw_create_from(&scene_source_drawn, settings, facts,
                                  visibility);
}

SceneDraw scene_draw_create_from(const SceneSource *source,
                                 const BaseSettings *settings, Facts *facts,
                                 const char *const visibility[])
{
    static const char *const unshadowed[] = {
        "step1_shadowmap/shaders/unshadowed.glsl", NULL};
    gl_check_size("size", settings->size[0], settings->size[1]);
    if (!facts_look_up(facts)) {
        visibility = unshadowed;
    }
    SceneDraw draw = {.footprint = uses_footprint(visibility),
                      .width = settings->size[0],
                      .height = settings->size[1]};
    plan_add(&facts->plan, "derivatives", -1, draw.footprint, 0, 0, "%s",
             draw.footprint ? "lookups as wide as a pixel is in the map"
                            : "no lookup asks how wide a pixel is in the map");
    choose_outputs(&draw, settings);
    draw.program =
        create_program(source, settings, facts->scene->light.kind, visibility);
    draw.shaded = strcmp(settings->show, "shaded") == 0;
    draw.legend =
        legend_create(base_shader_files(settings), base_show_mode(settings),
                      draw.width, draw.height);
    create_framebuffer(&draw);
    return draw;
}

// 1 - cos(angle), without taking two numbers near 1 from each other.
static float spread_of(double angle)
{
    double half = sin(0.5 * angle);
    return (float)(2 * half * half);
}

// A light that is not a spot has a cone that holds every direction, and one
// that is parallel is everywhere at the distance where its radiance holds.
static void set_falloff(GLuint program, const Light *light)
{
    bool local = light->kind != LIGHT_DIRECTIONAL;
    bool spot = light->kind == LIGHT_SPOT;
    glUniform1f(glGetUniformLocation(program, "reference_distance"),
                local ? (float)light->reference : 1);
    glUniform3f(glGetUniformLocation(program, "cone_axis"),
                (float)light->direction[0], (float)light->direction[1],
                (float)light->direction[2]);
    glUniform2f(glGetUniformLocation(program, "cone_spreads"),
                spot ? spread_of(light->cone) : 4,
                spot ? spread_of(BRIGHT_PART * light->cone) : 3);
}

static void set_uniforms(GLuint program, const Scene *scene, const Views *views)
{
    const Light *light = &scene->light;
    view_set_matrix(program, "clip_from_relative", views->clip_from_relative);
    view_set_light(program, views);
    set_falloff(program, light);
    glUniform1i(glGetUniformLocation(program, "shadow_map"), 0);
    glUniform3fv(glGetUniformLocation(program, "radiance"), 1, light->radiance);
    glUniform3fv(glGetUniformLocation(program, "ambient"), 1, light->ambient);
}

static void clear(const SceneDraw *draw, const Scene *scene)
{
    float background[4] = {1, 1, 1, 1};
    if (draw->shaded) {
        memcpy(background, scene->background, sizeof scene->background);
    }
    glClearBufferfv(GL_COLOR, 0, background);
    for (int i = 1; i < SCENE_DRAW_OUTPUTS; i++) {
        glClearBufferfv(GL_COLOR, i, outputs[i].empty); // if it is there
    }
    const float far_depth = 1;
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
}

void scene_draw_begin(const SceneDraw *draw, const Scene *scene,
                      const Views *views, GLuint map)
{
    glBindFramebuffer(GL_FRAMEBUFFER, draw->framebuffer);
    glViewport(0, 0, draw->width, draw->height);
    glDrawBuffers(SCENE_DRAW_OUTPUTS, draw->buffers);
    clear(draw, scene);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(draw->program.id);
    set_uniforms(draw->program.id, scene, views);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, map);
}

void scene_draw_end(const SceneDraw *draw)
{
    legend_draw(&draw->legend);
}

void scene_draw(const SceneDraw *draw, const Scene *scene,
                const Geometry *geometry, const Views *views, GLuint map)
{
    scene_draw_begin(draw, scene, views, map);
    geometry_draw(geometry, scene, &views->seen, views->origin);
    scene_draw_end(draw);
}

bool scene_draw_reload(SceneDraw *draw)
{
    return gl_program_reload(&draw->program) && legend_reload(&draw->legend);
}

void scene_draw_write(const SceneDraw *draw, const BaseSettings *settings)
{
    const char *path = settings->output;
    if (path != NULL) {
        float *pixels =
            gl_read(draw->framebuffer, 0, draw->width, draw->height, 3);
        image_write(path, pixels, draw->width, draw->height, 3);
        free(pixels);
        base_say_written(settings, path, "");
    }
    if (settings->dump != NULL) {
        base_say_written(settings, settings->dump, "/");
    }
}

void scene_draw_dump(const SceneDraw *draw, const char *directory)
{
    for (int i = 0; i < SCENE_DRAW_OUTPUTS; i++) {
        if (draw->buffers[i] == GL_NONE) {
            continue;
        }
        float *pixels = gl_read(draw->framebuffer, i, draw->width, draw->height,
                                outputs[i].channels);
        dump_image(directory, outputs[i].name, pixels, draw->width,
                   draw->height, outputs[i].channels);
        free(pixels);
    }
}

void scene_draw_destroy(SceneDraw *draw)
{
    legend_destroy(&draw->legend);
    glDeleteRenderbuffers(1, &draw->depth_buffer);
    glDeleteTextures(SCENE_DRAW_OUTPUTS, draw->outputs);
    glDeleteFramebuffers(1, &draw->framebuffer);
    gl_program_destroy(&draw->program);
    *draw = (SceneDraw){0};
}
