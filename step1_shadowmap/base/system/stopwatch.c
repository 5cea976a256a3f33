#define _POSIX_C_SOURCE 200809L // clock_gettime

#include "step1_shadowmap/base/system/stopwatch.h"

#include <glad/gl.h> // glFinish
#include <string.h>  // strcmp
#include <time.h>    // clock_gettime

#include "step1_shadowmap/base/system/die.h" // die

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

void touch(Touched *touched, size_t texels, size_t bytes_for_each)
{
    touched->texels += texels;
    touched->bytes += texels * bytes_for_each;
}

void stopwatch_start(Stopwatch *stopwatch)
{
    glFinish();
    stopwatch->passes = 0;
    stopwatch->started = now();
}

void stopwatch_lap(Stopwatch *stopwatch, const char *name, Touched touched)
{
    glFinish();
    int pass = 0;
    while (pass < stopwatch->passes &&
           strcmp(stopwatch->name[pass], name) != 0) {
        pass++;
    }
    if (pass == STOPWATCH_MAX_PASSES) {
        die("more than %d passes to time", STOPWATCH_MAX_PASSES);
    }
    double time = now();
    if (pass == stopwatch->passes) {
        stopwatch->passes++;
        stopwatch->name[pass] = name;
        stopwatch->touched[pass] = (Touched){0, 0};
        stopwatch->milliseconds[pass] = 0;
    }
    stopwatch->touched[pass].texels += touched.texels;
    stopwatch->touched[pass].bytes += touched.bytes;
    stopwatch->milliseconds[pass] += time - stopwatch->started;
    stopwatch->started = time;
}

double stopwatch_total(const Stopwatch *stopwatch)
{
    double total = 0;
    for (int pass = 0; pass < stopwatch->passes; pass++) {
        total += stopwatch->milliseconds[pass];
    }
    return total;
}
