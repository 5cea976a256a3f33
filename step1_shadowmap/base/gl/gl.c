#include "step1_shadowmap/base/gl/gl.h"

#include "step1_shadowmap/base/system/die.h" // allocate, die, die_usage, ...

static void GLAD_API_PTR stop_on_error(GLenum source, GLenum type, GLuint id,
                                       GLenum severity, GLsizei length,
                                       const GLchar *message, const void *user)
{
    (void)id, (void)severity, (void)length, (void)user;
    // What the compiler says is in its log, which we read ourselves.
    if (type == GL_DEBUG_TYPE_ERROR &&
        source != GL_DEBUG_SOURCE_SHADER_COMPILER) {
        die("OpenGL error: %s", message);
    }
}

void gl_load(GlLoader loader)
{
    int version = gladLoadGL((GLADloadfunc)loader);
    if (version < GLAD_MAKE_VERSION(3, 3)) {
        die("OpenGL %d.%d found; these programs need 3.3",
            GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version));
    }
    // A pointer for the callback exists under any invented name: only the
    // version says whether it works.
    if (version >= GLAD_MAKE_VERSION(4, 3)) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(stop_on_error, NULL);
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

// A texture that does not fit is refused before the driver tries: it may give
// addresses without memory behind them, and the process is killed later.
static void check_memory(GLenum format, int width, int height, int layers)
{
    size_t texels = (size_t)width * (size_t)height * (size_t)layers;
    memory_check(texels * gl_texel_bytes(format),
                 "a texture of %dx%d texels and %d layer%s", width, height,
                 layers, layers == 1 ? "" : "s");
}

static void allocate_level(GLenum format, int level, int width, int height,
                           int layers)
{
    bool whole = format == GL_RG32UI; // numbers
    glTexImage3D(GL_TEXTURE_2D_ARRAY, level, (GLint)format, width, height,
                 layers, 0, whole ? GL_RG_INTEGER : GL_RED,
                 whole ? GL_UNSIGNED_INT : GL_FLOAT, NULL);
}

void gl_add_level(GLenum format, int level, int width, int height, int layers)
{
    check_memory(format, width, height, layers);
    allocate_level(format, level, width, height, layers);
}

GLuint gl_texture_array(GLenum format, int width, int height, int layers,
                        Sampling sampling)
{
    GLint filter = (GLint)sampling.filter;
    GLuint texture;
    check_memory(format, width, height, layers);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    allocate_level(format, 0, width, height, layers);
    GLenum target = GL_TEXTURE_2D_ARRAY;
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, sampling.far);
    return texture;
}

GLuint gl_sampler(Sampling sampling)
{
    GLint filter = (GLint)sampling.filter;
    GLuint sampler;
    glGenSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glSamplerParameterfv(sampler, GL_TEXTURE_BORDER_COLOR, sampling.far);
    return sampler;
}

size_t gl_texel_bytes(GLenum format)
{
    switch (format) {
    case GL_NONE: // no such output
        return 0;
    case GL_R32F:
    case GL_RG16F:
    case GL_DEPTH_COMPONENT32F:
        return 4;
    case GL_RG32F:
    case GL_RG32UI:
        return 8;
    case GL_RGBA32F:
        return 16;
    default:
        die("no size for the format 0x%x", format);
    }
}

GLuint gl_texture(GLenum format, int width, int height)
{
    GLuint texture;
    check_memory(format, width, height, 1);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)format, width, height, 0, GL_RED,
                 GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

GLuint gl_depth_buffer(int width, int height, int samples)
{
    GLuint buffer;
    check_memory(GL_DEPTH_COMPONENT32F, width, height, 1);
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples,
                                     GL_DEPTH_COMPONENT32F, width, height);
    return buffer;
}

void gl_check_framebuffer(const char *what)
{
    GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        die("the framebuffer of %s is incomplete (status 0x%x)", what, status);
    }
}

float *gl_read(GLuint framebuffer, int attachment, int width, int height,
               int channels)
{
    static const GLenum formats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    size_t texels = (size_t)width * (size_t)height;
    float *values = allocate(texels, (size_t)channels * sizeof *values);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)attachment);
    glReadPixels(0, 0, width, height, formats[channels - 1], GL_FLOAT, values);
    return values;
}

float *gl_read_layer(GLuint texture, int level, int layer, int width,
                     int height, int channels)
{
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture,
                              level, layer);
    gl_check_framebuffer("a map's layer");
    float *values = gl_read(framebuffer, 0, width, height, channels);
    glDeleteFramebuffers(1, &framebuffer);
    return values;
}

void gl_draw_fullscreen(GLuint empty_vao)
{
    glBindVertexArray(empty_vao);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void gl_check_size(const char *option, int width, int height)
{
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width > limit || height > limit) {
        die_usage("--%s %dx%d is over this driver's limit of %dx%d", option,
                  width, height, limit, limit);
    }
}
