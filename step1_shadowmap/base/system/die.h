// How a program stops: at the first error, with one line.
#ifndef BASE_DIE_H
#define BASE_DIE_H

#include <stddef.h> // size_t

#ifdef __cplusplus
extern "C" {
#endif

// Prints "program: message" on stderr and exits with status 1: something that
// the user asked for could not be done (no memory, unwritable file, no GL).
void die(const char *format, ...)
    __attribute__((noreturn, format(printf, 1, 2)));

// The same with status 2: the command line itself is wrong.
void die_usage(const char *format, ...)
    __attribute__((noreturn, format(printf, 1, 2)));

// Prints "program: message" on stderr and goes on: about an error in a shader,
// in a window where the user is about to mend it, and about times that mislead.
void complain(const char *format, ...) __attribute__((format(printf, 1, 2)));

// count * size bytes, all zero; free() them. Dies when there is no memory.
void *allocate(size_t count, size_t size);

#ifdef __cplusplus
}
#endif

#endif
