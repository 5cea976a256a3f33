// Files that stand in place of others, in every list that names them.
#include <string.h> // strcmp, strcpy, strlen

#include "step1_shadowmap/base/seams/technique.h" // gl_put_instead
#include "step1_shadowmap/base/gl/shader_file.h"  // shader_stage
#include "step1_shadowmap/base/system/die.h"      // die

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

void gl_put_in_front(Shaders *shaders, const char *definitions)
{
    size_t length = strlen(shaders->front);
    if (length + strlen(definitions) >= sizeof shaders->front) {
        die("more than %d bytes of definitions", SHADERS_FRONT_BYTES);
    }
    strcpy(shaders->front + length, definitions);
}

// Whether the running stage has the file already.
static bool has_file(const char *const files[], int count, const char *name)
{
    while (count > 0 && shader_stage(files[count - 1]) == 0) {
        if (strcmp(files[--count], name) == 0) {
            return true;
        }
    }
    return false;
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
        } else if (!has_file(files, count, *names)) {
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
