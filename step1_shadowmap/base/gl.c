#include "step1_shadowmap/base/gl.h"

#include <stdbool.h>
#include <stdio.h>  // fopen, snprintf, sscanf
#include <stdlib.h> // free
#include <string.h> // strchr, strcspn, strstr

#include "step1_shadowmap/base/die.h" // allocate, die, die_usage

enum {
    MAX_FILES = 12,
    LINES_PER_FILE = 10000,
    PATH_BYTES = 4096,
    LOG_BYTES = 4096
};

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

// The whole file as a string, or NULL if it cannot be opened.
static char *read_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return NULL;
    }
    size_t length = 0;
    size_t room = 1 << 14;
    char *text = allocate(room, 1);
    while (!feof(file) && !ferror(file) && length + 1 < room) {
        length += fread(text + length, 1, room - length - 1, file);
    }
    if (ferror(file) || !feof(file)) {
        die("cannot read %s (or it is over %zu bytes)", path, room - 1);
    }
    fclose(file);
    return text;
}

static char *read_shader(ShaderFiles where, const char *name)
{
    char path[PATH_BYTES];
    char *text = NULL;
    if (where.directory != NULL) {
        snprintf(path, sizeof path, "%s/%s", where.directory, name);
        text = read_file(path);
    }
    if (text == NULL) {
        snprintf(path, sizeof path, "%s/%s", SHADER_ROOT, name);
        text = read_file(path);
    }
    if (text == NULL) {
        die("missing shader file %s", path);
    }
    return text;
}

// Drivers put the number of the source string and the line in front, as in
// "0:30014(5): error: ..." (Mesa) or "0(30014) : error ..." (NVIDIA). Prints
// the first line that says "error" with the file's name and its own line.
static _Noreturn void stop_on_log(const char *log, const char *const files[])
{
    const char *line = log;
    while (strstr(line, "error") != NULL && strchr(line, '\n') != NULL &&
           strstr(line, "error") > strchr(line, '\n')) {
        line = strchr(line, '\n') + 1;
    }
    int length = (int)strcspn(line, "\n");
    int file = 0;
    while (files[file + 1] != NULL) {
        file++;
    }
    int number = 0;
    int skipped = 0;
    if (sscanf(line, "%*d%*[:(]%d%*[^:]%n", &number, &skipped) != 1 ||
        number / LINES_PER_FILE > file) {
        die("shader %s: %.*s", files[file], length, line);
    }
    die("shader %s:%d%.*s", files[number / LINES_PER_FILE],
        number % LINES_PER_FILE, length - skipped, line + skipped);
}

static GLuint compile(ShaderFiles where, GLenum type, const char *const files[])
{
    // The line in front of a file numbers its lines so that they name the file
    // too. (The number of the source string, meant for that, is lost by Mesa in
    // most of its messages.)
    char before[MAX_FILES][48];
    const char *sources[2 * MAX_FILES];
    char *texts[MAX_FILES];
    int count = 0;
    for (; files[count] != NULL; count++) {
        snprintf(before[count], sizeof before[count], "%s\n#line %d\n",
                 count == 0 ? "#version 330 core" : "",
                 count * LINES_PER_FILE + 1);
        texts[count] = read_shader(where, files[count]);
        sources[2 * count] = before[count];
        sources[2 * count + 1] = texts[count];
    }
    GLuint shader = glCreateShader(type);
    glShaderSource(shader, 2 * count, sources, NULL);
    glCompileShader(shader);
    for (int i = 0; i < count; i++) {
        free(texts[i]);
    }
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[LOG_BYTES];
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        stop_on_log(log, files);
    }
    return shader;
}

GLuint gl_program(ShaderFiles where, const char *const vertex[],
                  const char *const fragment[])
{
    GLuint shaders[2] = {compile(where, GL_VERTEX_SHADER, vertex),
                         compile(where, GL_FRAGMENT_SHADER, fragment)};
    GLuint program = glCreateProgram();
    for (int i = 0; i < 2; i++) {
        glAttachShader(program, shaders[i]);
    }
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[LOG_BYTES];
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        stop_on_log(log, fragment);
    }
    for (int i = 0; i < 2; i++) {
        glDetachShader(program, shaders[i]);
        glDeleteShader(shaders[i]);
    }
    return program;
}

GLuint gl_texture_array(GLenum format, int width, int height, int layers,
                        GLenum filter)
{
    static const float far_depth[4] = {1, 1, 1, 1};
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, (GLint)format, width, height, layers,
                 0, GL_RED, GL_FLOAT, NULL);
    GLenum target = GL_TEXTURE_2D_ARRAY;
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, (GLint)filter);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, (GLint)filter);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, far_depth);
    return texture;
}

size_t gl_texel_bytes(GLenum format)
{
    switch (format) {
    case GL_R32F:
    case GL_RG16F:
    case GL_DEPTH_COMPONENT32F:
        return 4;
    case GL_RG32F:
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
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)format, width, height, 0, GL_RED,
                 GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

GLuint gl_layer_framebuffer(GLuint texture, int layer, GLuint depth_buffer)
{
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0,
                              layer);
    if (depth_buffer != 0) {
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                  GL_RENDERBUFFER, depth_buffer);
    }
    gl_check_framebuffer("of a map's layer");
    return framebuffer;
}

GLuint gl_depth_buffer(int width, int height)
{
    GLuint buffer;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width,
                          height);
    return buffer;
}

void gl_check_framebuffer(const char *what)
{
    GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        die("the framebuffer %s is incomplete (status 0x%x)", what, status);
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

float *gl_read_layer(GLuint texture, int layer, int width, int height,
                     int channels)
{
    GLuint framebuffer = gl_layer_framebuffer(texture, layer, 0);
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
