// Whether there is memory for something large.
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include <stddef.h> // size_t

#ifdef __cplusplus
extern "C" {
#endif

// Bytes that this process can still get: what the system has left, and at most
// what a limit on the process (ulimit -v) leaves it.
size_t memory_left(void);

// Dies with one line, that says how many bytes are asked for and how many are
// left, where these are too few. To be called before they are allocated: what
// has no memory behind it is often given all the same, and the process is
// killed when it uses it. `format` says what they are for.
void memory_check(size_t bytes, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#ifdef __cplusplus
}
#endif

#endif
