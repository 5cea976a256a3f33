// The programs of gl.h: compiled, linked, and compiled again.
#include "step1_shadowmap/base/gl/gl.h"

#include <stdio.h>  // snprintf, sscanf
#include <stdlib.h> // free
#include <string.h> // strchr, strcmp, strcpy, strcspn, strlen, strstr

#include "step1_shadowmap/base/gl/shader_file.h" // shader_read
#include "step1_shadowmap/base/system/die.h"     // allocate, complain, die

enum { LINES_PER_FILE = 10000, LOG_BYTES = 4096 };

// Drivers put the number of the source string and the line in front, as in
// "0:30014(5): error: ..." (Mesa) or "0(30014) : error ..." (NVIDIA). The
// message is the first line that says "error", with the name of the file that
// was read and its own line.
static void explain_log(const char *log, const Program *program,
                        const char *const files[], int count, char *message)
{
    char path[SHADER_PATH_BYTES];
    const char *line = log;
    while (strstr(line, "error") != NULL && strchr(line, '\n') != NULL &&
           strstr(line, "error") > strchr(line, '\n')) {
        line = strchr(line, '\n') + 1;
    }
    int length = (int)strcspn(line, "\n");
    int number = 0;
    int skipped = 0;
    bool numbered =
        sscanf(line, "%*d%*[:(]%d%*[^:]%n", &number, &skipped) == 1 &&
        number / LINES_PER_FILE < count;
    shader_find(program->shaders->directory,
                files[numbered ? number / LINES_PER_FILE : count - 1], path);
    if (numbered) {
        snprintf(message, SHADER_MESSAGE_BYTES, "shader %s:%d%.*s", path,
                 number % LINES_PER_FILE, length - skipped, line + skipped);
    } else {
        snprintf(message, SHADER_MESSAGE_BYTES, "shader %s: %.*s", path, length,
                 line);
    }
}

// The shader, or 0 and the message.
static GLuint compile_texts(GLenum type, const Program *program,
                            const char *const files[], int count,
                            char *const texts[], char *message)
{
    // The line in front of a file numbers its lines so that they name the file
    // too. (The number of the source string, meant for that, is lost by Mesa in
    // most of its messages.)
    char before[PROGRAM_MAX_FILES][24];
    const char *sources[2 + 2 * PROGRAM_MAX_FILES] = {shader_version(type),
                                                      program->constants};
    for (int i = 0; i < count; i++) {
        snprintf(before[i], sizeof before[i], "\n#line %d\n",
                 i * LINES_PER_FILE + 1);
        sources[2 + 2 * i] = before[i];
        sources[3 + 2 * i] = texts[i];
    }
    GLuint shader = glCreateShader(type);
    glShaderSource(shader, 2 + 2 * count, sources, NULL);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[LOG_BYTES] = "";
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        explain_log(log, program, files, count, message);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

// One stage of the program, of so many files.
static GLuint compile(const Program *program, const char *const files[],
                      int count, char *message)
{
    char *texts[PROGRAM_MAX_FILES] = {NULL};
    GLuint shader = 0;
    int read = 0;
    bool complete = true;
    while (complete && read < count) {
        texts[read] =
            shader_read(program->shaders->directory, files[read], message);
        complete = texts[read++] != NULL;
    }
    if (complete) {
        shader = compile_texts(shader_stage(files[count - 1]), program, files,
                               count, texts, message);
    }
    for (int i = 0; i < read; i++) {
        free(texts[i]);
    }
    return shader;
}

// Compiles a stage after the other into a program; false and the message if
// one does not compile. They go when the program does.
static bool attach_stages(GLuint id, const Program *program, char *message)
{
    const char *const *first = program->files;
    for (const char *const *file = first; *file != NULL; file++) {
        if (shader_stage(*file) != 0) {
            GLuint shader =
                compile(program, first, (int)(file + 1 - first), message);
            if (shader == 0) {
                return false;
            }
            glAttachShader(id, shader);
            glDeleteShader(shader);
            first = file + 1;
        }
    }
    return true;
}

static void blame_last_stage(const char *log, const Program *program,
                             char *message)
{
    int first = 0, count = 0;
    for (; program->files[count] != NULL; count++) {
        if (count > 0 && shader_stage(program->files[count - 1]) != 0) {
            first = count;
        }
    }
    explain_log(log, program, program->files + first, count - first, message);
}

// The linked program, or 0 and the message. One that does not link blames the
// last stage.
static GLuint build(const Program *program, char *message)
{
    GLuint id = glCreateProgram();
    GLint linked = GL_FALSE;
    bool compiled = attach_stages(id, program, message);
    if (compiled) {
        glLinkProgram(id);
        glGetProgramiv(id, GL_LINK_STATUS, &linked);
    }
    if (compiled && !linked) {
        char log[LOG_BYTES] = "";
        glGetProgramInfoLog(id, sizeof log, NULL, log);
        blame_last_stage(log, program, message);
    }
    if (!linked) {
        glDeleteProgram(id);
        return 0;
    }
    return id;
}

Program *gl_program(Shaders *shaders, const char *constants,
                    const char *const files[])
{
    Program *program = allocate(1, sizeof *program);
    const char *own = constants == NULL ? "" : constants;
    size_t bytes = strlen(own) + strlen(shaders->front) + 1;
    program->shaders = shaders;
    program->next = shaders->programs;
    shaders->programs = program;
    program->constants = allocate(bytes, 1);
    snprintf(program->constants, bytes, "%s%s", own, shaders->front);
    for (int i = 0; files[i] != NULL && i < PROGRAM_MAX_FILES; i++) {
        program->files[i] = files[i];
    }
    if (gl_find_files != NULL) {
        gl_find_files(shaders, files, program->files);
    }
    return program;
}

GLuint gl_use(Program *program)
{
    char message[SHADER_MESSAGE_BYTES];
    if (program->id == 0) {
        program->id = build(program, message);
    }
    if (program->id == 0) {
        die("%s", message);
    }
    glUseProgram(program->id);
    return program->id;
}

void gl_compile(Shaders *shaders)
{
    for (Program *program = shaders->programs; program != NULL;
         program = program->next) {
        gl_use(program);
    }
}

bool gl_reload(Shaders *shaders)
{
    char message[SHADER_MESSAGE_BYTES];
    for (Program *program = shaders->programs; program != NULL;
         program = program->next) {
        GLuint id = program->id == 0 ? 0 : build(program, message);
        if (id == 0 && program->id != 0) {
            complain("%s", message);
            return false;
        }
        glDeleteProgram(program->id); // the name 0 is ignored
        program->id = id;
    }
    return true;
}

void gl_destroy_programs(Shaders *shaders)
{
    while (shaders->programs != NULL) {
        Program *program = shaders->programs;
        shaders->programs = program->next;
        glDeleteProgram(program->id);
        free(program->constants);
        free(program);
    }
}
