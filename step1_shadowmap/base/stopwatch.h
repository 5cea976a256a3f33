// Wall-clock time of OpenGL passes.
#ifndef BASE_STOPWATCH_H
#define BASE_STOPWATCH_H

enum {
    STOPWATCH_MAX_PASSES = 8,
    STOPWATCH_MAX_FRAMES = 1024, // the warm-up included
    STOPWATCH_WARM_UP = 3 // frames: a program's code is made at its first draw
};

// Times in milliseconds of every frame, by pass, in the order of the passes.
typedef struct Stopwatch {
    const char *name[STOPWATCH_MAX_PASSES];
    double milliseconds[STOPWATCH_MAX_PASSES][STOPWATCH_MAX_FRAMES];
    int passes;
    int frames;     // begun
    int pass;       // of the running lap
    double started; // of the running lap, milliseconds since some fixed time
} Stopwatch;

// Waits until OpenGL has nothing left to do, then starts a frame's first lap.
// After STOPWATCH_MAX_FRAMES the last frame is measured again.
void stopwatch_start(Stopwatch *stopwatch);

// Waits for OpenGL, records the lap under `name` and starts the next one.
// Without the wait the clock would measure how fast commands are queued.
void stopwatch_lap(Stopwatch *stopwatch, const char *name);

// The last frame's time of a pass, in milliseconds.
double stopwatch_last(const Stopwatch *stopwatch, int pass);

// The last frame's time of all passes together, in milliseconds.
double stopwatch_total(const Stopwatch *stopwatch);

// Prints, as CSV on stdout, a header and for each pass and for their total:
// name, median, first and third quartile over the frames after the warm-up
// (milliseconds), number of these frames, the clock, and each frame's time,
// so that several runs can be pooled. Nothing where no frame was to be timed
// (--bench 0).
void stopwatch_print(const Stopwatch *stopwatch, int bench);

#endif
