#include "step1_shadowmap/base/files/file.h"

#include <errno.h>
#include <stdio.h>    // fopen
#include <string.h>   // strerror
#include <sys/stat.h> // mkdir, stat

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
