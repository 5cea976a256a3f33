// How a program stops: at the first error, with one line.
#ifndef BASE_DIE_H
#define BASE_DIE_H

#include <stddef.h> // size_t

// A function of a room that a program can do without: NULL where it is not
// linked.
#define IF_LINKED __attribute__((weak))

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

// Dies if something that was printed on stdout did not get there: the disk is
// full, or nobody reads it.
void printed_check(void);

// base/safety has these three.

// To be called before all else, so that what happens to a program from outside
// ends in one line too.
IF_LINKED void safety_prepare(void);

// Dies if so many bytes are too many, before they are allocated: what has no
// memory behind it is often given all the same, and the process is killed when
// it uses it. `format` says what they are for.
void memory_check(size_t bytes, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#ifdef __cplusplus
}
#endif

#endif
