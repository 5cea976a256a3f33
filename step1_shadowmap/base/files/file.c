#define _GNU_SOURCE // program_invocation_name, readlink, realpath

#include "step1_shadowmap/base/files/file.h"

#include <errno.h>    // errno, program_invocation_name
#include <limits.h>   // PATH_MAX
#include <stdio.h>    // fopen, snprintf
#include <stdlib.h>   // realpath
#include <string.h>   // strerror, strrchr
#include <sys/stat.h> // mkdir, stat
#include <unistd.h>   // readlink

#include "step1_shadowmap/base/system/die.h" // die

__attribute__((weak)) void file_write(const char *path, const void *bytes,
                                      size_t count)
{
    FILE *file = fopen(path, "wb");
    bool written = file != NULL && fwrite(bytes, 1, count, file) == count;
    if (file == NULL || fclose(file) != 0 || !written) {
        die("cannot write %s: %s", path, strerror(errno));
    }
}

bool file_is_directory(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

void file_make_directory(const char *path)
{
    if (mkdir(path, 0777) != 0 && errno != EEXIST) {
        die("cannot make the directory %s: %s", path, strerror(errno));
    }
    if (!file_is_directory(path)) {
        die("%s is not a directory", path);
    }
}

// Without links in it. It may be gone: make has built another since.
static bool find_program(char path[FILE_NAME_BYTES])
{
    char found[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", path, FILE_NAME_BYTES - 1);
    if (length > 0) {
        path[length] = '\0';
        return true;
    }
    // Where there is no /proc.
    if (realpath(program_invocation_name, found) == NULL) {
        return false;
    }
    snprintf(path, FILE_NAME_BYTES, "%s", found);
    return true;
}

bool tree_find(char folder[FILE_NAME_BYTES])
{
    char step[FILE_NAME_BYTES + 32];
    bool found = false;
    folder[0] = '\0';
    if (!find_program(folder)) {
        return false;
    }
    while (!found && strrchr(folder, '/') != NULL) {
        *strrchr(folder, '/') = '\0';
        snprintf(step, sizeof step, "%s/step1_shadowmap", folder);
        found = file_is_directory(step);
    }
    return found;
}
