// OpenGL objects, always checked: a program that does not compile, a texture
// that is too large or a framebuffer that is incomplete stops the run with one
// line that names it.
#ifndef BASE_GL_H
#define BASE_GL_H

#include <glad/gl.h>
#include <stdbool.h>
#include <stddef.h> // size_t

#include "step1_shadowmap/base/system/die.h" // IF_LINKED

typedef void (*GlFunction)(void);
typedef GlFunction (*GlLoader)(const char *name);

// Loads the GL functions of the current context, demands version 3.3 and
// makes every GL error fatal from here on.
void gl_load(GlLoader loader);

enum { PROGRAM_MAX_FILES = 32 };

enum { SHADERS_MAX_INSTEAD = 32, SHADERS_FRONT_BYTES = 512 };

typedef struct Program Program;

// Where shader files are looked up: first below `directory` (NULL: nowhere),
// then in the source tree. Names are paths from the tree's top, such as
// "step1_shadowmap/shaders/scene.frag". And all programs made of them.
typedef struct Shaders {
    const char *directory;
    Program *programs;
    struct {
        const char *file;
        const char *const *files;
    } instead[SHADERS_MAX_INSTEAD];
    int instead_count;
    char front[SHADERS_FRONT_BYTES];
} Shaders;

// The files that a list of names stands for, NULL at the end, at most
// PROGRAM_MAX_FILES; without base/seams the names themselves. What a stage has
// already comes no second time.
IF_LINKED void gl_find_files(const Shaders *shaders, const char *const names[],
                             const char *files[PROGRAM_MAX_FILES + 1]);

struct Program {
    GLuint id; // 0 before the program is used
    Program *next;
    const Shaders *shaders;
    char *constants;
    const char *files[PROGRAM_MAX_FILES + 1]; // names, NULL after the last
};

// A program of several shader files, NULL at the end; the names stay valid. The
// files of a stage are compiled as one shader, in that order. The last one has
// main(), and its name says which stage it is: .vert, .geom, .frag or .comp.
// Each begins with the names that it needs from others, or from C, and offers.
// They carry no #version line (it may come only once, before all else); 330
// core is put in front, of compute shaders 430 core. So are `constants`, of
// which a copy is kept: definitions in GLSL of what is known only at run time,
// or NULL. Nothing is read or compiled before the program is used.
Program *gl_program(Shaders *shaders, const char *constants,
                    const char *const files[]);

// Uses the program from here on, and returns its name for glUniform. Compiles
// it the first time: an error stops the run with the file and line that it is
// in.
GLuint gl_use(Program *program);

// Compiles all programs that were not used yet: after that a file that somebody
// breaks cannot stop the run.
void gl_compile(Shaders *shaders);

// Reads the files of all programs that were compiled again. If they compile,
// the new programs take the place of the old ones, with all uniforms at 0; else
// one line on stderr gives the file and line, that program stays as it was, and
// the result is false.
bool gl_reload(Shaders *shaders);

void gl_destroy_programs(Shaders *shaders);

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

// Adds a mip-map level to the array texture that is bound.
void gl_add_level(GLenum format, int level, int width, int height, int layers);

// A 2D texture of so many samples per texel. Refuses (status 2, it is --msaa's)
// a number that this driver does not have.
IF_LINKED GLuint gl_texture_samples(GLenum format, int width, int height,
                                    int samples);

// A renderbuffer of 32-bit float depth; samples 0: one for each texel.
GLuint gl_depth_buffer(int width, int height, int samples);

// Dies if the bound draw framebuffer is incomplete; `what` names what it draws.
void gl_check_framebuffer(const char *what);

// The float texels of colour attachment `attachment` of a framebuffer: rows
// from the bottom up, `channels` (1 to 4) values each; the caller frees them.
float *gl_read(GLuint framebuffer, int attachment, int width, int height,
               int channels);

// The same for one layer of a mip-map level of an array texture; width and
// height are the level's.
float *gl_read_layer(GLuint texture, int level, int layer, int width,
                     int height, int channels);

// One triangle that covers the viewport, without any vertex data.
void gl_draw_fullscreen(GLuint empty_vao);

// Dies if width or height is over what this driver's textures hold; `option`
// is the command-line option to blame.
void gl_check_size(const char *option, int width, int height);

#endif
