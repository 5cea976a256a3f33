#include "step1_shadowmap/base/picture/picture.h"

#include <stdlib.h> // free
#include <string.h> // memcpy, strcmp

#include "step1_shadowmap/base/files/image.h"  // image_write
#include "step1_shadowmap/base/picture/dump.h" // dump_image
#include "step1_shadowmap/base/system/die.h"   // die

enum { MAX_FILES = PROGRAM_MAX_FILES };

// The place of the picture itself in the list below.
enum { OUTPUT_IMAGE = 0 };

// What the fragment shader writes, in the order of its output locations.
static const struct {
    const char *name;
    GLenum format;
    int channels;
    float empty[4]; // where the picture shows no object
} outputs[TARGET_MAX_OUTPUTS] = {
    {"image", GL_RGBA32F, 3, {0, 0, 0, 0}}, // the scene's background
    {"receiver", GL_RGBA32F, 4, {0, 0, 0, -1}},
    {"position", GL_RGBA32F, 3, {0, 0, 0, 0}},
    {"normal", GL_RGBA32F, 3, {0, 0, 0, 0}},
    {"visibility", GL_R32F, 1, {1, 1, 1, 1}},
    {"footprint", GL_RGBA32F, 4, {0, 0, 0, 0}}, // where it is used
    {"handover", GL_RGBA32F, 4, {0, 0, 0, 0}},  // where it is used
};

static void choose_outputs(Picture *picture, const BaseSettings *settings)
{
    int count = settings->dump == NULL ? 1 : PICTURE_FOOTPRINT;
    for (int i = 0; i < count; i++) {
        picture->target.formats[i] = outputs[i].format;
    }
}

static Program *create_program(Frame *frame, const char *constants,
                               const char *const visibility[])
{
    const BaseSettings *settings = &frame->settings;
    const ShowMode *mode = base_show_mode(settings);
    const char *files[MAX_FILES] = {
        "step1_shadowmap/shaders/scene.vert",
        "step1_shadowmap/base/picture/shaders/surface.glsl",
        "step1_shadowmap/shaders/light_depth.glsl",
        "step1_shadowmap/shaders/linear_depth.glsl",
        "step1_shadowmap/shaders/map_coordinates.glsl"};
    int count = 5;
    for (int i = 0; visibility[i] != NULL; i++) {
        if (count + 5 > MAX_FILES) {
            die("more than %d shader files", MAX_FILES);
        }
        files[count++] = visibility[i];
    }
    if (mode->scale != NULL) {
        files[count++] = mode->scale;
    }
    files[count++] = mode->shader;
    files[count++] =
        settings->dump == NULL
            ? "step1_shadowmap/base/picture/shaders/dump_nothing.glsl"
            : "step1_shadowmap/base/picture/shaders/dump.glsl";
    files[count] = "step1_shadowmap/shaders/scene.frag";
    return gl_program(&frame->shaders, constants, files);
}

void picture_create(Picture *picture, Frame *frame, Target *map,
                    const char *constants, const char *const visibility[])
{
    const BaseSettings *settings = &frame->settings;
    visibility = frame->visibility != NULL ? frame->visibility : visibility;
    *picture = (Picture){.map = map, .visibility = visibility};
    picture->target = (Target){.pass = "picture",
                               .kind = TARGET_PICTURE,
                               .width = settings->size[0],
                               .height = settings->size[1],
                               .layers = 1,
                               .depth = true};
    choose_outputs(picture, settings);
    if (techniques_create != NULL) {
        techniques_create(frame, picture);
    }
    target_add(&frame->targets, &picture->target);
    picture->program = create_program(frame, constants, visibility);
    picture->legend = legend_create == NULL ? NULL : legend_create(frame);
}

static void set_uniforms(GLuint program, const Scene *scene, const Views *views)
{
    const Light *light = &scene->light;
    view_set_matrix(program, "clip_from_relative", views->clip_from_relative);
    view_set_light(program, views);
    glUniform1i(glGetUniformLocation(program, "shadow_map"), 0);
    glUniform3fv(glGetUniformLocation(program, "radiance"), 1, light->radiance);
    glUniform3fv(glGetUniformLocation(program, "ambient"), 1, light->ambient);
}

static void clear(const Frame *frame)
{
    const float far_depth = 1;
    float background[4] = {1, 1, 1, 1};
    if (strcmp(frame->settings.show, "shaded") == 0) {
        memcpy(background, frame->scene.background,
               sizeof frame->scene.background);
    }
    glClearBufferfv(GL_COLOR, 0, background);
    for (int i = 1; i < TARGET_MAX_OUTPUTS; i++) {
        glClearBufferfv(GL_COLOR, i, outputs[i].empty); // if it is there
    }
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
}

GLuint picture_begin(Picture *picture, Frame *frame)
{
    if (techniques_after != NULL) {
        techniques_after(frame);
    }
    GLuint program = gl_use(picture->program);
    picture->drawing = target_begin(&picture->target, 0);
    if (picture->drawing) {
        clear(frame);
    }
    glEnable(GL_DEPTH_TEST);
    set_uniforms(program, &frame->scene, &frame->views);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY,
                  frame->looks_up ? target_texture(picture->map) : 0);
    if (techniques_look != NULL) {
        techniques_look(frame, program);
    }
    return program;
}

void picture_draw(const Picture *picture, const Frame *frame)
{
    if (!picture->drawing) {
        return;
    }
    if (techniques_shade == NULL || !techniques_shade(frame, picture)) {
        geometry_draw(&frame->geometry, &frame->scene, &frame->views.seen,
                      frame->views.origin);
    }
    if (legend_draw != NULL) {
        legend_draw(picture->legend, frame);
    }
}

// One of the picture's outputs; the caller frees it.
static float *read_output(const Picture *picture, int output)
{
    const Target *target = &picture->target;
    return gl_read(target->framebuffers[0], output, target->width,
                   target->height, outputs[output].channels);
}

void picture_write(const Picture *picture, const char *path)
{
    float *pixels = read_output(picture, OUTPUT_IMAGE);
    image_write(path, pixels, picture->target.width, picture->target.height, 3);
    free(pixels);
}

void picture_dump(const Picture *picture, const char *directory)
{
    const Target *target = &picture->target;
    for (int i = 0; i < TARGET_MAX_OUTPUTS; i++) {
        if (target->formats[i] != GL_NONE) {
            float *pixels = read_output(picture, i);
            dump_image(directory, outputs[i].name, pixels, target->width,
                       target->height, outputs[i].channels);
            free(pixels);
        }
    }
}
