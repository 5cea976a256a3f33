// OpenGL objects, always checked: a program that does not compile, a texture
// that is too large or a framebuffer that is incomplete stops the run with one
// line that names it.
#ifndef BASE_GL_H
#define BASE_GL_H

#include <glad/gl.h>
#include <stdbool.h>
#include <stddef.h> // size_t

#include "step1_shadowmap/base/gl/rect.h" // Rect

typedef void (*GlFunction)(void);
typedef GlFunction (*GlLoader)(const char *name);

// Loads the GL functions of the current context, demands version 3.3 and
// makes every GL error fatal from here on.
void gl_load(GlLoader loader);

// Where shader files are looked up: first below `directory` (NULL: nowhere),
// then in the source tree. Names are paths from the tree's top, such as
// "step1_shadowmap/shaders/scene.frag". What the files take for constants, and
// is known only at run time, is put in front of them: definitions in GLSL, or
// NULL, which stay valid as long as the program.
typedef struct ShaderFiles {
    const char *directory;
    const char *constants;
} ShaderFiles;

enum { PROGRAM_MAX_FILES = 24 };

// A program, and the files that it is made of: names that stay valid, NULL
// after the last. It has either vertex and fragment files, or compute files.
typedef struct Program {
    GLuint id;
    ShaderFiles where;
    const char *compute[PROGRAM_MAX_FILES + 1];
    const char *vertex[PROGRAM_MAX_FILES + 1];
    const char *geometry[PROGRAM_MAX_FILES + 1]; // none: no such stage
    const char *fragment[PROGRAM_MAX_FILES + 1];
} Program;

// A program of several shader files: each list ends with NULL and its files
// are compiled as one shader, in that order. They carry no #version line (it
// may come only once, before all else); 330 core is put in front. A compile
// error stops the run with the file and line that it is in.
Program gl_program(ShaderFiles where, const char *const vertex[],
                   const char *const fragment[]);

// Whether this driver has compute shaders (OpenGL 4.3).
bool gl_has_compute(void);

// The same of a compute shader, which is in version 430 core.
Program gl_compute_program(ShaderFiles where, const char *const files[]);

// The same with a geometry shader between the two.
Program gl_program_of_triangles(ShaderFiles where, const char *const vertex[],
                                const char *const geometry[],
                                const char *const fragment[]);

// Reads the files again. If they compile, the new program takes the old one's
// place, with all its uniforms at 0; else one line on stderr gives the file and
// line, the old program stays, and the result is false. A program that was
// never made (all zero) is left alone.
bool gl_program_reload(Program *program);

void gl_program_destroy(Program *program);

// How a map is looked up.
typedef struct Sampling {
    GLenum filter; // GL_NEAREST or GL_LINEAR, between texels
    float far[4];  // what it holds outside, and where nothing is drawn
} Sampling;

// A 2D array texture without mip-maps, `layers` x width x height texels, all
// undefined.
GLuint gl_texture_array(GLenum format, int width, int height, int layers,
                        Sampling sampling);

// A sampler object: bound to a unit it is used in place of what the texture
// there has of its own.
GLuint gl_sampler(Sampling sampling);

// Bytes of one texel of the formats that these programs use.
size_t gl_texel_bytes(GLenum format);

// A plain 2D texture, read with texelFetch.
GLuint gl_texture(GLenum format, int width, int height);

// A framebuffer that draws into one layer of an array texture; depth_buffer is
// a renderbuffer or 0.
GLuint gl_layer_framebuffer(GLuint texture, int layer, GLuint depth_buffer);

// The same for one mip-map level, without depth.
GLuint gl_level_framebuffer(GLuint texture, int level, int layer);

// A renderbuffer of 32-bit float depth.
GLuint gl_depth_buffer(int width, int height);

// Dies if the bound draw framebuffer is incomplete; `what` names it.
void gl_check_framebuffer(const char *what);

// The float texels of colour attachment `attachment` of a framebuffer: rows
// from the bottom up, `channels` (1 to 4) values each; the caller frees them.
float *gl_read(GLuint framebuffer, int attachment, int width, int height,
               int channels);

// The same for one layer of a mip-map level of an array texture; width and
// height are the level's.
float *gl_read_layer(GLuint texture, int level, int layer, int width,
                     int height, int channels);

// Limits everything that is drawn and cleared to a rectangle, until
// gl_unlimit().
void gl_limit(const Rect *rect);
void gl_unlimit(void);

// One triangle that covers the viewport, without any vertex data.
void gl_draw_fullscreen(GLuint empty_vao);

// Dies if width or height is over what this driver's textures hold; `option`
// is the command-line option to blame.
void gl_check_size(const char *option, int width, int height);

#endif
