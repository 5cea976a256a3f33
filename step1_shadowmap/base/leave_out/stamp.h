// Whether something has changed: a number for all that it is made from.
#ifndef BASE_STAMP_H
#define BASE_STAMP_H

#include <stddef.h> // size_t
#include <stdint.h> // uint64_t

#define STAMP_START 0xcbf29ce484222325

// Fowler, Noll and Vo's hash, 64 bits: a change that it misses is once in
// 2^64.
void stamp_add(uint64_t *stamp, const void *data, size_t bytes);

#endif
