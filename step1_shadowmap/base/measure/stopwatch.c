#define _POSIX_C_SOURCE 200809L // clock_gettime

#include "step1_shadowmap/base/measure/stopwatch.h"

#include <glad/gl.h> // glFinish
#include <string.h>  // strcmp
#include <time.h>    // clock_gettime

#include "step1_shadowmap/base/picture/frame.h" // frame_lap, frame_start
#include "step1_shadowmap/base/system/die.h"    // die

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

// Waits until OpenGL has nothing left to do, then starts a frame's first lap,
// which what is planned before the first pass belongs to.
static void stopwatch_start(Stopwatch *stopwatch)
{
    glFinish();
    stopwatch->passes = 0;
    stopwatch->started = now();
}

// Waits for OpenGL, records the lap under `name` and starts the next one. Laps
// of one name in a frame are added up.
// Without the wait the clock would measure how fast commands are queued.
static void stopwatch_lap(Stopwatch *stopwatch, const char *name,
                          Touched touched)
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

// The time of all passes together, in milliseconds.
static double stopwatch_total(const Stopwatch *stopwatch)
{
    double total = 0;
    for (int pass = 0; pass < stopwatch->passes; pass++) {
        total += stopwatch->milliseconds[pass];
    }
    return total;
}

static Stopwatch state;

const Stopwatch *measure_clock(void)
{
    return &state;
}

void frame_start(void)
{
    stopwatch_start(&state);
}

void frame_lap(Frame *frame, const char *name)
{
    bool picture = false;
    for (int i = 0; i < frame->targets.count; i++) {
        const Target *target = frame->targets.list[i];
        picture = picture || (target->kind == TARGET_PICTURE &&
                              target->touched.texels > 0);
    }
    Touched touched = targets_touched(&frame->targets);
    if (target_limit != NULL) {
        target_limit(NULL);
    }
    if (frame->dump == NULL && (frame->looks_up || picture)) {
        stopwatch_lap(&state, name, touched);
    }
}

double frame_milliseconds(void)
{
    return stopwatch_total(&state);
}
