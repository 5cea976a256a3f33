#define _POSIX_C_SOURCE 200809L // lstat

#include "step1_shadowmap/base/gl/shader_file.h"

#include <errno.h>
#include <stdio.h>    // fopen, snprintf
#include <stdlib.h>   // free
#include <string.h>   // memmove, strcmp, strlen, strncmp, strrchr
#include <sys/stat.h> // lstat

#include "step1_shadowmap/base/system/die.h" // allocate

enum { FILE_BYTES = 1 << 14 }; // of the longest file, with the final 0

GLenum shader_stage(const char *name)
{
    static const struct {
        const char *ending;
        GLenum type;
    } stages[] = {{".vert", GL_VERTEX_SHADER},
                  {".geom", GL_GEOMETRY_SHADER},
                  {".frag", GL_FRAGMENT_SHADER},
                  {".comp", GL_COMPUTE_SHADER}};
    const char *ending = strrchr(name, '.');
    for (int i = 0; i < 4; i++) {
        if (ending != NULL && strcmp(ending, stages[i].ending) == 0) {
            return stages[i].type;
        }
    }
    return 0;
}

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

bool shader_find(const char *directory, const char *name,
                 char path[SHADER_PATH_BYTES])
{
    char tree[FILE_NAME_BYTES];
    if (directory != NULL) {
        snprintf(path, SHADER_PATH_BYTES, "%s/%s", directory, name);
        if (is_there(path)) {
            return true;
        }
    }
    bool found = tree_find(tree);
    snprintf(path, SHADER_PATH_BYTES, "%s/%s", tree, name);
    return found;
}

char *shader_read(const char *directory, const char *name,
                  char message[SHADER_MESSAGE_BYTES])
{
    char path[SHADER_PATH_BYTES];
    if (!shader_find(directory, name, path)) {
        snprintf(message, SHADER_MESSAGE_BYTES,
                 "no shaders: this program is in no folder below one that "
                 "holds %s; put it back, or say --shaders DIR",
                 name);
        return NULL;
    }
    FILE *file = fopen(path, "rb");
    if (file == NULL && errno == ENOENT) {
        snprintf(message, SHADER_MESSAGE_BYTES, "missing shader file %s", path);
        return NULL;
    }
    char *text = file == NULL ? NULL : read_all(file);
    if (text == NULL) {
        snprintf(message, SHADER_MESSAGE_BYTES,
                 "cannot read %s (or it is no text, or over %d bytes)", path,
                 FILE_BYTES - 1);
    }
    if (file != NULL) {
        fclose(file);
    }
    return text;
}

const char *shader_version(GLenum type)
{
    return type == GL_COMPUTE_SHADER ? "#version 430 core\n"
                                     : "#version 330 core\n";
}
