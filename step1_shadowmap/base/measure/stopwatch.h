// Wall-clock time of a frame's OpenGL passes, and what they touch.
#ifndef BASE_STOPWATCH_H
#define BASE_STOPWATCH_H

#include "step1_shadowmap/base/gl/target.h" // Touched

enum { STOPWATCH_MAX_PASSES = 8 };

// Of the last frame's passes, in their order.
typedef struct Stopwatch {
    const char *name[STOPWATCH_MAX_PASSES];
    double milliseconds[STOPWATCH_MAX_PASSES];
    Touched touched[STOPWATCH_MAX_PASSES];
    int passes;     // so far
    double started; // of the running lap, milliseconds since some fixed time
} Stopwatch;

const Stopwatch *measure_clock(void);

// What has been drawn since the last call; resets it.
Touched targets_touched(Targets *targets);

// Bytes of all textures that were made for the light's passes.
size_t targets_map_bytes(const Targets *targets);

#endif
