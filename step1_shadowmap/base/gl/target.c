#include "step1_shadowmap/base/gl/target.h"

#include <string.h> // memmove

#include "step1_shadowmap/base/system/die.h" // die

void target_want_all(Target *target)
{
    for (int layer = 0; layer < target->layers; layer++) {
        target->layer[layer].wanted =
            (Rect){{0, 0}, {target->width, target->height}};
        target->layer[layer].draw = true;
    }
}

void target_insert(Targets *targets, int place, Target *target)
{
    if (targets->count == TARGETS_MAX) {
        die("more than %d targets", TARGETS_MAX);
    }
    memmove(&targets->list[place + 1], &targets->list[place],
            sizeof targets->list[0] * (size_t)(targets->count - place));
    targets->list[place] = target;
    targets->count++;
    target_want_all(target);
}

void target_add(Targets *targets, Target *target)
{
    target_insert(targets, targets->count, target);
}

Target target_reading(Target *source, const char *pass, int factor)
{
    return (Target){.pass = pass,
                    .kind = source->kind,
                    .width = source->width / factor,
                    .height = source->height / factor,
                    .layers = source->layers,
                    .formats = {source->formats[0]},
                    .sampling = source->sampling,
                    .reads = source,
                    .scale = factor};
}

Target target_alias(Target *of)
{
    Target target = target_reading(of, NULL, 1);
    target.shares = of;
    target.alias = true;
    return target;
}

static void make_layers(Target *target)
{
    int levels = target->levels > 1 ? target->levels : 1;
    gl_check_size("map-size", target->width, target->height);
    target->textures[0] =
        gl_texture_array(target->formats[0], target->width, target->height,
                         target->layers, target->sampling);
    for (int level = 0; level < levels; level++) {
        int width = target->width >> level, height = target->height >> level;
        if (level > 0) {
            gl_add_level(target->formats[0], level, width, height,
                         target->layers);
        }
    }
}

static void make_textures(Target *target)
{
    if (target->shares != NULL) {
        target->textures[0] = target_texture(target->shares);
        return;
    }
    if (target->kind == TARGET_LAYERS) {
        make_layers(target);
    } else if (target->kind == TARGET_SAMPLES) {
        target->textures[0] = gl_texture_samples(
            target->formats[0], target->width, target->height, target->samples);
    } else {
        gl_check_size("size", target->width, target->height);
        for (int i = 0; i < TARGET_MAX_OUTPUTS; i++) {
            if (target->formats[i] != GL_NONE) {
                target->textures[i] = gl_texture(target->formats[i],
                                                 target->width, target->height);
            }
        }
    }
    if (target->depth) {
        target->depth_buffer =
            gl_depth_buffer(target->width, target->height, target->samples);
    }
}

static GLenum attachment(int output)
{
    return GL_COLOR_ATTACHMENT0 + (GLenum)output;
}

static void attach(const Target *target, int layer)
{
    GLenum kind = target->kind == TARGET_SAMPLES ? GL_TEXTURE_2D_MULTISAMPLE
                                                 : GL_TEXTURE_2D;
    for (int i = 0; i < TARGET_MAX_OUTPUTS; i++) {
        GLuint texture = target->textures[i];
        if (texture != 0 && target->kind == TARGET_LAYERS) {
            glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment(i), texture,
                                      target->level, layer);
        } else if (texture != 0) {
            glFramebufferTexture2D(GL_FRAMEBUFFER, attachment(i), kind, texture,
                                   0);
        }
    }
    GLuint depth_buffer = target->depth_buffer;
    if (target->depth_of != NULL) {
        target_texture(target->depth_of);
        depth_buffer = target->depth_of->depth_buffer;
    }
    if (depth_buffer != 0) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                  GL_RENDERBUFFER, depth_buffer);
    }
    gl_check_framebuffer(target->pass);
}

// On a unit of its own: a pass may have bound already what it reads.
GLuint target_texture(Target *target)
{
    if (target->textures[0] == 0) {
        glActiveTexture(GL_TEXTURE15);
        make_textures(target);
        glActiveTexture(GL_TEXTURE0);
    }
    return target->textures[0];
}

const Rect *target_wanted(Target *target, int layer)
{
    const Rect *wanted = &target->layer[layer].wanted;
    if (target->alias || !target->layer[layer].draw) {
        return NULL;
    }
    target_texture(target);
    if (target_touch != NULL) {
        target_touch(target, wanted);
    }
    return wanted;
}

static void draw_all_outputs(const Target *target)
{
    GLenum buffers[TARGET_MAX_OUTPUTS];
    for (int i = 0; i < TARGET_MAX_OUTPUTS; i++) {
        buffers[i] = target->textures[i] == 0 ? GL_NONE : attachment(i);
    }
    glDrawBuffers(TARGET_MAX_OUTPUTS, buffers);
}

bool target_begin(Target *target, int layer)
{
    const Rect *wanted = target_wanted(target, layer);
    if (wanted == NULL) {
        return false;
    }
    GLuint *framebuffer = &target->framebuffers[layer];
    if (*framebuffer == 0) {
        glGenFramebuffers(1, framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
        attach(target, layer);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
    draw_all_outputs(target);
    glViewport(0, 0, target->width, target->height);
    if (target_limit != NULL) {
        target_limit(wanted);
    }
    return true;
}

void targets_destroy(Targets *targets)
{
    for (int i = targets->count - 1; i >= 0; i--) {
        Target *target = targets->list[i];
        glDeleteFramebuffers(TARGET_MAX_LAYERS, target->framebuffers);
        glDeleteRenderbuffers(1, &target->depth_buffer);
        if (target->shares == NULL) {
            glDeleteTextures(TARGET_MAX_OUTPUTS, target->textures);
        }
    }
    targets->count = 0;
}
