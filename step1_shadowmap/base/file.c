#define _POSIX_C_SOURCE 200809L // getpid, stat

#include "step1_shadowmap/base/file.h"

#include <errno.h>
#include <stdio.h>    // rename, remove, snprintf
#include <string.h>   // strerror, strrchr
#include <sys/stat.h> // mkdir, stat
#include <unistd.h>   // getpid

#include "step1_shadowmap/base/die.h" // die

void file_temporary_name(const char *path, char name[FILE_NAME_BYTES])
{
    const char *slash = strrchr(path, '/');
    const char *base = slash == NULL ? path : slash + 1;
    const char *dot = strrchr(base, '.');
    int length =
        snprintf(name, FILE_NAME_BYTES, "%.*s.partial-%ld%s",
                 (int)(base - path), path, (long)getpid(), dot ? dot : "");
    if (length < 0 || length >= FILE_NAME_BYTES) {
        die("the file name %.40s... is too long", path);
    }
}

void file_finish(const char *temporary, const char *path)
{
    if (rename(temporary, path) != 0) {
        file_give_up(temporary, path, strerror(errno));
    }
}

void file_give_up(const char *temporary, const char *path, const char *reason)
{
    remove(temporary);
    die("cannot write %s: %s", path, reason);
}

void file_make_directory(const char *path)
{
    struct stat status;
    if (mkdir(path, 0777) != 0 && errno != EEXIST) {
        die("cannot make the directory %s: %s", path, strerror(errno));
    }
    if (stat(path, &status) != 0 || !S_ISDIR(status.st_mode)) {
        die("%s is not a directory", path);
    }
}
