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
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include <stdbool.h>
#include <stddef.h> // size_t

enum { FILE_NAME_BYTES = 4096 };

#ifdef __cplusplus
extern "C" {
#endif

// Writes the bytes as a file of this name; dies if that cannot be done to the
// last byte, and then leaves the old file, or none if there was none.
void file_write(const char *path, const void *bytes, size_t count);

// Makes the directory if it is not there (its parent must be); dies if it
// cannot be made or is something else.
void file_make_directory(const char *path);

bool file_is_directory(const char *path);

#ifdef __cplusplus
}
#endif

#endif
