#define _POSIX_C_SOURCE 200809L // clock_gettime

#include "step1_shadowmap/base/stopwatch.h"

#include <glad/gl.h> // glFinish
#include <time.h>    // clock_gettime

#include "step1_shadowmap/base/die.h" // die

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

void stopwatch_start(Stopwatch *stopwatch)
{
    glFinish();
    stopwatch->count = 0;
    stopwatch->started = now();
}

void stopwatch_lap(Stopwatch *stopwatch, const char *name)
{
    glFinish();
    if (stopwatch->count == STOPWATCH_MAX_PASSES) {
        die("more than %d passes to time", STOPWATCH_MAX_PASSES);
    }
    double time = now();
    stopwatch->name[stopwatch->count] = name;
    stopwatch->milliseconds[stopwatch->count] = time - stopwatch->started;
    stopwatch->count++;
    stopwatch->started = time;
}
