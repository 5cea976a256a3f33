// Files and folders. With base/safety a file appears whole or not at all.
#ifndef BASE_FILE_H
#define BASE_FILE_H

#include <stdbool.h>
#include <stddef.h> // size_t

enum { FILE_NAME_BYTES = 4096 };

#ifdef __cplusplus
extern "C" {
#endif

// Writes the bytes as a file of this name; dies if that cannot be done to the
// last byte.
void file_write(const char *path, const void *bytes, size_t count);

// Makes the directory if it is not there (its parent must be); dies if it
// cannot be made or is something else.
void file_make_directory(const char *path);

bool file_is_directory(const char *path);

// A program reads its shaders from the tree that it is in, so that a copy of
// the tree reads its own.

// The innermost folder around the program's file that holds step1_shadowmap/;
// false where there is none.
bool tree_find(char folder[FILE_NAME_BYTES]);

// Refuses (status 2) a folder for --shaders that is not there or is not laid
// out as the tree. NULL is none.
void file_check_shaders(const char *folder);

#ifdef __cplusplus
}
#endif

#endif
