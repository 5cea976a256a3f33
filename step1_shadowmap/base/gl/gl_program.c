// The programs of gl.h: read, compiled, linked, and read again.
#define _POSIX_C_SOURCE 200809L // lstat

#include "step1_shadowmap/base/gl/gl.h"

#include <errno.h>
#include <stdio.h>    // fopen, snprintf, sscanf
#include <stdlib.h>   // free
#include <string.h>   // memmove, strchr, strcspn, strlen, strncmp, strstr
#include <sys/stat.h> // lstat

#include "step1_shadowmap/base/system/die.h" // allocate, complain, die
#include "step1_shadowmap/base/files/tree.h" // tree_find

enum {
    LINES_PER_FILE = 10000,
    FILE_BYTES = 1 << 14, // of the longest shader file, with the final 0
    PATH_BYTES = 2 * FILE_NAME_BYTES,
    LOG_BYTES = 4096,
    MESSAGE_BYTES = PATH_BYTES + LOG_BYTES + 64
};

struct Program {
    GLuint id; // 0 before the program is used
    Program *next;
    const Shaders *shaders;
    char *constants; // or NULL
    // Names of files, NULL after the last. It has either vertex and fragment
    // files, or compute files.
    const char *compute[PROGRAM_MAX_FILES + 1];
    const char *vertex[PROGRAM_MAX_FILES + 1];
    const char *geometry[PROGRAM_MAX_FILES + 1]; // none: no such stage
    const char *fragment[PROGRAM_MAX_FILES + 1];
};

// What is left of the file as a string; NULL if it cannot be read or is no
// text. A byte order mark, which some editors put in front, is none of GLSL.
static char *read_all(FILE *file)
{
    static const char mark[] = "\xef\xbb\xbf";
    char *text = allocate(FILE_BYTES, 1);
    size_t length = 0;
    while (!feof(file) && !ferror(file) && length + 1 < FILE_BYTES) {
        length += fread(text + length, 1, FILE_BYTES - length - 1, file);
    }
    if (ferror(file) || !feof(file) || strlen(text) != length) {
        free(text);
        return NULL;
    }
    if (strncmp(text, mark, strlen(mark)) == 0) {
        memmove(text, text + strlen(mark), length + 1 - strlen(mark));
    }
    return text;
}

static bool is_there(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0; // a link to nothing is there
}

// The file that is read for this name: that of --shaders, or the tree's. False
// where there is no tree.
static bool find_shader(const Program *program, const char *name,
                        char path[PATH_BYTES])
{
    char tree[FILE_NAME_BYTES];
    if (program->shaders->directory != NULL) {
        snprintf(path, PATH_BYTES, "%s/%s", program->shaders->directory, name);
        if (is_there(path)) {
            return true;
        }
    }
    bool found = tree_find(tree);
    snprintf(path, PATH_BYTES, "%s/%s", tree, name);
    return found;
}

// The text of a shader file, or NULL and what is wrong with it.
static char *read_shader(const Program *program, const char *name,
                         char *message)
{
    char path[PATH_BYTES];
    if (!find_shader(program, name, path)) {
        snprintf(message, MESSAGE_BYTES,
                 "no shaders: this program is in no folder below one that "
                 "holds %s; put it back, or say --shaders DIR",
                 name);
        return NULL;
    }
    FILE *file = fopen(path, "rb");
    if (file == NULL && errno == ENOENT) {
        snprintf(message, MESSAGE_BYTES, "missing shader file %s", path);
        return NULL;
    }
    char *text = file == NULL ? NULL : read_all(file);
    if (text == NULL) {
        snprintf(message, MESSAGE_BYTES,
                 "cannot read %s (or it is no text, or over %d bytes)", path,
                 FILE_BYTES - 1);
    }
    if (file != NULL) {
        fclose(file);
    }
    return text;
}

// Drivers put the number of the source string and the line in front, as in
// "0:30014(5): error: ..." (Mesa) or "0(30014) : error ..." (NVIDIA). The
// message is the first line that says "error", with the name of the file that
// was read and its own line.
static void explain_log(const char *log, const Program *program,
                        const char *const files[], char *message)
{
    char path[PATH_BYTES];
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
    bool numbered =
        sscanf(line, "%*d%*[:(]%d%*[^:]%n", &number, &skipped) == 1 &&
        number / LINES_PER_FILE <= file;
    find_shader(program, files[numbered ? number / LINES_PER_FILE : file],
                path);
    if (numbered) {
        snprintf(message, MESSAGE_BYTES, "shader %s:%d%.*s", path,
                 number % LINES_PER_FILE, length - skipped, line + skipped);
    } else {
        snprintf(message, MESSAGE_BYTES, "shader %s: %.*s", path, length, line);
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
    const char *sources[2 + 2 * PROGRAM_MAX_FILES] = {
        type == GL_COMPUTE_SHADER ? "#version 430 core\n"
                                  : "#version 330 core\n",
        program->constants == NULL ? "" : program->constants};
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
        explain_log(log, program, files, message);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

static GLuint compile(const Program *program, GLenum type,
                      const char *const files[], char *message)
{
    char *texts[PROGRAM_MAX_FILES] = {NULL};
    GLuint shader = 0;
    int count = 0;
    bool complete = true;
    while (complete && files[count] != NULL) {
        texts[count] = read_shader(program, files[count], message);
        complete = texts[count++] != NULL;
    }
    if (complete) {
        shader = compile_texts(type, program, files, count, texts, message);
    }
    for (int i = 0; i < count; i++) {
        free(texts[i]);
    }
    return shader;
}

// The linked program, or 0 and the message, which blames the last shader's
// files.
static GLuint link_shaders(const Program *program, int count,
                           const GLuint shaders[], const char *const files[],
                           char *message)
{
    GLuint id = glCreateProgram();
    for (int i = 0; i < count; i++) {
        glAttachShader(id, shaders[i]);
    }
    glLinkProgram(id);
    for (int i = 0; i < count; i++) {
        glDetachShader(id, shaders[i]);
    }
    GLint linked = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[LOG_BYTES] = "";
        glGetProgramInfoLog(id, sizeof log, NULL, log);
        explain_log(log, program, files, message);
        glDeleteProgram(id);
        return 0;
    }
    return id;
}

static GLuint build_compute(const Program *program, char *message)
{
    GLuint id = 0;
    GLuint shader =
        compile(program, GL_COMPUTE_SHADER, program->compute, message);
    if (shader != 0) {
        id = link_shaders(program, 1, &shader, program->compute, message);
    }
    glDeleteShader(shader);
    return id;
}

static GLuint build_drawing(const Program *program, char *message)
{
    const struct {
        GLenum type;
        const char *const *files;
    } stages[] = {{GL_VERTEX_SHADER, program->vertex},
                  {GL_FRAGMENT_SHADER, program->fragment},
                  {GL_GEOMETRY_SHADER, program->geometry}};
    int count = program->geometry[0] != NULL ? 3 : 2;
    GLuint id = 0;
    GLuint shaders[3] = {0};
    bool compiled = true;
    for (int i = 0; compiled && i < count; i++) {
        shaders[i] = compile(program, stages[i].type, stages[i].files, message);
        compiled = shaders[i] != 0;
    }
    if (compiled) {
        id = link_shaders(program, count, shaders, program->fragment, message);
    }
    for (int i = 0; i < count; i++) {
        glDeleteShader(shaders[i]); // the name 0 is ignored
    }
    return id;
}

static GLuint build(const Program *program, char *message)
{
    return program->compute[0] != NULL ? build_compute(program, message)
                                       : build_drawing(program, message);
}

void gl_put_instead(Shaders *shaders, const char *file,
                    const char *const files[])
{
    for (int i = 0; i < shaders->instead_count; i++) {
        if (strcmp(shaders->instead[i].file, file) == 0) {
            return;
        }
    }
    if (shaders->instead_count == SHADERS_MAX_INSTEAD) {
        die("more than %d shader files are replaced", SHADERS_MAX_INSTEAD);
    }
    shaders->instead[shaders->instead_count].file = file;
    shaders->instead[shaders->instead_count++].files = files;
}

// Appends what a list stands for, but takes `but` as it is.
static int append_files(const Shaders *shaders, const char *const names[],
                        const char *but, const char *files[], int count)
{
    for (; *names != NULL; names++) {
        const char *const *instead = NULL;
        for (int i = 0; i < shaders->instead_count; i++) {
            if (strcmp(shaders->instead[i].file, *names) == 0 &&
                (but == NULL || strcmp(but, *names) != 0)) {
                instead = shaders->instead[i].files;
            }
        }
        if (instead != NULL) {
            count = append_files(shaders, instead, *names, files, count);
        } else if (count == PROGRAM_MAX_FILES) {
            die("more than %d shader files", PROGRAM_MAX_FILES);
        } else {
            files[count++] = *names;
        }
    }
    files[count] = NULL;
    return count;
}

void gl_find_files(const Shaders *shaders, const char *const names[],
                   const char *files[PROGRAM_MAX_FILES + 1])
{
    append_files(shaders, names, NULL, files, 0);
}

static Program *add_program(Shaders *shaders, const char *constants)
{
    Program *program = allocate(1, sizeof *program);
    program->shaders = shaders;
    program->next = shaders->programs;
    shaders->programs = program;
    if (constants != NULL) {
        program->constants = allocate(strlen(constants) + 1, 1);
        strcpy(program->constants, constants);
    }
    return program;
}

Program *gl_program(Shaders *shaders, const char *constants,
                    const char *const vertex[], const char *const fragment[])
{
    Program *program = add_program(shaders, constants);
    gl_find_files(shaders, vertex, program->vertex);
    gl_find_files(shaders, fragment, program->fragment);
    return program;
}

Program *gl_program_of_triangles(Shaders *shaders, const char *constants,
                                 const char *const vertex[],
                                 const char *const geometry[],
                                 const char *const fragment[])
{
    Program *program = gl_program(shaders, constants, vertex, fragment);
    gl_find_files(shaders, geometry, program->geometry);
    return program;
}

Program *gl_compute_program(Shaders *shaders, const char *constants,
                            const char *const files[])
{
    Program *program = add_program(shaders, constants);
    gl_find_files(shaders, files, program->compute);
    return program;
}

GLuint gl_use(Program *program)
{
    char message[MESSAGE_BYTES];
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
    char message[MESSAGE_BYTES];
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
