#define _POSIX_C_SOURCE 200809L // getpid, stat

#include "step1_shadowmap/base/file.h"

#include <errno.h>
#include <stdio.h>    // fopen, rename, remove, snprintf
#include <string.h>   // strerror, strrchr
#include <sys/stat.h> // mkdir, stat
#include <unistd.h>   // getpid

#include "step1_shadowmap/base/die.h" // die

// A name beside the file's own, so that the rename stays on one disk.
static void temporary_name(const char *path, char name[FILE_NAME_BYTES])
{
    const char *slash = strrchr(path, '/');
    int folder = slash == NULL ? 0 : (int)(slash + 1 - path);
    int length = snprintf(name, FILE_NAME_BYTES, "%.*s.partial-%ld", folder,
                          path, (long)getpid());
    if (length < 0 || length >= FILE_NAME_BYTES) {
        die("the file name %.40s... is too long", path);
    }
}

// Whether every byte is on the disk under this name, or at least accepted: a
// full disk may show only when the file is closed.
static bool write_bytes(const char *path, const void *bytes, size_t count)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        return false;
    }
    bool written = fwrite(bytes, 1, count, file) == count;
    int error = errno;
    if (fclose(file) != 0) {
        return false;
    }
    errno = error;
    return written;
}

void file_write(const char *path, const void *bytes, size_t count)
{
    char temporary[FILE_NAME_BYTES];
    temporary_name(path, temporary);
    if (!write_bytes(temporary, bytes, count) || rename(temporary, path) != 0) {
        const char *reason = strerror(errno);
        remove(temporary);
        die("cannot write %s: %s", path, reason);
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
