// Wall-clock time of OpenGL passes.
#ifndef BASE_STOPWATCH_H
#define BASE_STOPWATCH_H

enum { STOPWATCH_MAX_PASSES = 8 };

// Times in milliseconds, in the order in which the passes ran.
typedef struct Stopwatch {
    const char *name[STOPWATCH_MAX_PASSES];
    double milliseconds[STOPWATCH_MAX_PASSES];
    int count;
    double started; // of the running lap, milliseconds since some fixed time
} Stopwatch;

// Waits until OpenGL has nothing left to do, then starts the first lap.
void stopwatch_start(Stopwatch *stopwatch);

// Waits for OpenGL, records the lap under `name` and starts the next one.
// Without the wait the clock would measure how fast commands are queued.
void stopwatch_lap(Stopwatch *stopwatch, const char *name);

#endif
