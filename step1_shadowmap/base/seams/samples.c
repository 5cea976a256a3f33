// Textures of several samples per texel.
#include "step1_shadowmap/base/gl/gl.h"      // gl_texture_samples
#include "step1_shadowmap/base/system/die.h" // die_usage, memory_check

// Textures and renderbuffers have a limit each, and ours has both.
static void check_samples(int samples)
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
GLuint gl_texture_samples(GLenum format, int width, int height, int samples)
{
    GLenum target = GL_TEXTURE_2D_MULTISAMPLE;
    GLuint texture;
    GLint made = 0;
    check_samples(samples);
    memory_check(
        (size_t)samples * (size_t)width * (size_t)height *
            (gl_texel_bytes(format) + gl_texel_bytes(GL_DEPTH_COMPONENT32F)),
        "%d samples of %dx%d texels", samples, width, height);
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
