// The files that a shader program is made of.
#ifndef BASE_SHADER_FILE_H
#define BASE_SHADER_FILE_H

#include <glad/gl.h>
#include <stdbool.h>

#include "step1_shadowmap/base/files/file.h" // FILE_NAME_BYTES

enum {
    SHADER_PATH_BYTES = 2 * FILE_NAME_BYTES,
    SHADER_MESSAGE_BYTES = 2 * SHADER_PATH_BYTES
};

// The stage that a file is the last one of; 0: of none.
GLenum shader_stage(const char *name);

// The file that is read for this name: that of --shaders, or the tree's. False
// where there is no tree.
bool shader_find(const char *directory, const char *name,
                 char path[SHADER_PATH_BYTES]);

// The text of a shader file, which the caller frees, or NULL and what is wrong
// with it.
char *shader_read(const char *directory, const char *name,
                  char message[SHADER_MESSAGE_BYTES]);

// The first line of a stage.
const char *shader_version(GLenum type);

#endif
