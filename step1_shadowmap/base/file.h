// Files that appear whole or not at all: written under a temporary name in the
// same directory, then renamed.
#ifndef BASE_FILE_H
#define BASE_FILE_H

enum { FILE_NAME_BYTES = 4096 };

#ifdef __cplusplus
extern "C" {
#endif

// A temporary name beside `path` with the same ending (writers choose the
// format by it). Dies if the name is too long.
void file_temporary_name(const char *path, char name[FILE_NAME_BYTES]);

// Gives the finished temporary file its real name; dies if it cannot.
void file_finish(const char *temporary, const char *path);

// Removes the temporary file and dies: "cannot write PATH: reason".
void file_give_up(const char *temporary, const char *path, const char *reason)
    __attribute__((noreturn));

// Makes the directory if it is not there (its parent must be); dies if it
// cannot be made or is something else.
void file_make_directory(const char *path);

#ifdef __cplusplus
}
#endif

#endif
