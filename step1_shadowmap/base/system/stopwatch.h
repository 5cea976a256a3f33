// Wall-clock time of a frame's OpenGL passes, and what they touch.
#ifndef BASE_STOPWATCH_H
#define BASE_STOPWATCH_H

#include <stddef.h> // size_t

enum { STOPWATCH_MAX_PASSES = 8 };

// How much a pass has to do at least: the texels, pixels or samples that it
// writes, and the bytes of these and of those that it reads of what was drawn
// before it; each once per draw. What a picture's pixels look up is not
// counted.
typedef struct Touched {
    size_t texels;
    size_t bytes;
} Touched;

// Adds a draw of so many texels: bytes written and read for each of them.
void touch(Touched *touched, size_t texels, size_t bytes_for_each);

// Of the last frame's passes, in their order.
typedef struct Stopwatch {
    const char *name[STOPWATCH_MAX_PASSES];
    double milliseconds[STOPWATCH_MAX_PASSES];
    Touched touched[STOPWATCH_MAX_PASSES];
    int passes;     // so far
    double started; // of the running lap, milliseconds since some fixed time
} Stopwatch;

// Waits until OpenGL has nothing left to do, then starts a frame's first lap,
// which what is planned before the first pass belongs to.
void stopwatch_start(Stopwatch *stopwatch);

// Waits for OpenGL, records the lap under `name` and starts the next one. Laps
// of one name in a frame are added up.
// Without the wait the clock would measure how fast commands are queued.
void stopwatch_lap(Stopwatch *stopwatch, const char *name, Touched touched);

// The time of all passes together, in milliseconds.
double stopwatch_total(const Stopwatch *stopwatch);

#endif
