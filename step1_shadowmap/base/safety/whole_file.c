// Files that appear whole or not at all: written as .NAME.partial in the same
// folder, then renamed. A program that is killed meanwhile leaves that file
// behind; the next one that writes NAME takes it over.
//
// A link is followed: the file that it points to is replaced. Another name of
// the same file (a hard link) keeps the old one. The permissions stay, and a
// file that may not be written is not replaced either.
//
// Some files are written in place, so that a program that is killed leaves a
// part of them: what is no regular file (a pipe, a device), the file that a
// link promises, and one that nothing can be put beside or in the place of (a
// folder without write permission, a mounted file).
#define _GNU_SOURCE // AT_EACCESS, flock, realpath

#include <errno.h>
#include <fcntl.h> // faccessat, open
#include <stdbool.h>
#include <stdio.h>    // rename, snprintf
#include <stdlib.h>   // free, realpath
#include <string.h>   // strerror, strrchr
#include <sys/file.h> // flock
#include <sys/stat.h> // fchmod, fstat, lstat, stat
#include <unistd.h>   // close, dup, ftruncate, unlink, write

#include "step1_shadowmap/base/files/file.h" // file_write
#include "step1_shadowmap/base/system/die.h" // die

static bool write_bytes(int file, const char *bytes, size_t count)
{
    while (count > 0) {
        ssize_t written = write(file, bytes, count);
        if (written < 0 && errno != EINTR) {
            return false;
        }
        if (written > 0) {
            bytes += written;
            count -= (size_t)written;
        }
    }
    return true;
}

// Writes all of them. A full disk may show only when a file is closed: a copy
// of it is, and the file stays locked.
static bool fill(int file, const char *bytes, size_t count)
{
    return write_bytes(file, bytes, count) && close(dup(file)) == 0;
}

// Closes the file, and removes it if something has failed.
static void finish(int file, const char *path, bool failed)
{
    int reason = errno;
    if (failed) {
        unlink(path);
    }
    close(file);
    errno = reason;
}

static bool write_in_place(const char *path, const void *bytes, size_t count)
{
    bool old = access(path, F_OK) == 0;
    int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0) {
        return false;
    }
    bool written = fill(file, bytes, count);
    finish(file, path, !written && !old);
    return written;
}

// The file of this name, locked: another program that writes the same is waited
// for. It has renamed what we then hold the lock of, so we look again.
static int open_partial(const char *path)
{
    struct stat opened, named;
    for (;;) {
        int file = open(path, O_WRONLY | O_CREAT | O_NOFOLLOW, 0666);
        if (file < 0 || flock(file, LOCK_EX) != 0 ||
            fstat(file, &opened) != 0 ||
            (stat(path, &named) == 0 && named.st_dev == opened.st_dev &&
             named.st_ino == opened.st_ino)) {
            return file;
        }
        close(file);
    }
}

typedef enum Result { WRITTEN, FAILED, NO_PLACE } Result;

// Whether the folder is to blame, and not the bytes.
static Result no_place(void)
{
    bool folder = errno == EACCES || errno == EPERM || errno == EROFS ||
                  errno == EBUSY || errno == ENAMETOOLONG;
    return folder ? NO_PLACE : FAILED;
}

// `old` is the file that is to be replaced, or NULL.
static Result replace(const char *path, const struct stat *old,
                      const void *bytes, size_t count)
{
    char partial[FILE_NAME_BYTES];
    const char *slash = strrchr(path, '/');
    int folder = slash == NULL ? 0 : (int)(slash + 1 - path);
    int length = snprintf(partial, sizeof partial, "%.*s.%s.partial", folder,
                          path, path + folder);
    if (length < 0 || length >= FILE_NAME_BYTES) {
        return NO_PLACE;
    }
    int file = open_partial(partial);
    if (file < 0) {
        return no_place();
    }
    Result result = WRITTEN;
    if (ftruncate(file, 0) != 0 || !fill(file, bytes, count)) {
        result = FAILED;
    } else if ((old != NULL && fchmod(file, old->st_mode & 07777) != 0) ||
               rename(partial, path) != 0) {
        result = no_place();
    }
    finish(file, partial, result != WRITTEN);
    return result;
}

static bool write_file(const char *path, const void *bytes, size_t count)
{
    struct stat old, link;
    bool there = stat(path, &old) == 0;
    bool promised = !there && lstat(path, &link) == 0;
    char *target = realpath(path, NULL);
    Result result = NO_PLACE;
    if (there && faccessat(AT_FDCWD, path, W_OK, AT_EACCESS) != 0) {
        result = FAILED;
    } else if (there && S_ISREG(old.st_mode) && target != NULL) {
        result = replace(target, &old, bytes, count);
    } else if (!there && !promised) {
        result = replace(path, NULL, bytes, count);
    }
    free(target);
    return result == WRITTEN ||
           (result == NO_PLACE && write_in_place(path, bytes, count));
}

void file_write(const char *path, const void *bytes, size_t count)
{
    if (!write_file(path, bytes, count)) {
        die("cannot write %s: %s", path, strerror(errno));
    }
}
