// Wall-clock time of OpenGL passes, and what they touch.
#ifndef BASE_STOPWATCH_H
#define BASE_STOPWATCH_H

#include <stddef.h> // size_t

enum {
    STOPWATCH_MAX_PASSES = 8,
    STOPWATCH_MAX_FRAMES = 1024, // the warm-up included
    STOPWATCH_WARM_UP = 3 // frames: a program's code is made at its first draw
};

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

// Times in milliseconds of every frame, by pass, in the order of the passes.
typedef struct Stopwatch {
    const char *name[STOPWATCH_MAX_PASSES];
    double milliseconds[STOPWATCH_MAX_PASSES][STOPWATCH_MAX_FRAMES];
    Touched touched[STOPWATCH_MAX_PASSES]; // by the last frame
    int passes;
    int frames;     // begun
    int pass;       // of the running lap
    double started; // of the running lap, milliseconds since some fixed time
} Stopwatch;

// Waits until OpenGL has nothing left to do, then starts a frame's first lap,
// which what is planned before the first pass belongs to.
// After STOPWATCH_MAX_FRAMES the last frame is measured again.
void stopwatch_start(Stopwatch *stopwatch);

// Waits for OpenGL, records the lap under `name` and starts the next one. Laps
// of one name in a frame are added up.
// Without the wait the clock would measure how fast commands are queued.
void stopwatch_lap(Stopwatch *stopwatch, const char *name, Touched touched);

// The last frame's time of a pass, in milliseconds.
double stopwatch_last(const Stopwatch *stopwatch, int pass);

// The last frame's time of all passes together, in milliseconds.
double stopwatch_total(const Stopwatch *stopwatch);

// Prints, as CSV on stdout, a header and for each pass and for their total:
// name, median, first and third quartile over the frames after the warm-up
// (milliseconds), number of these frames, the clock, texels and bytes touched
// by the last frame, and each frame's time, so that several runs can be
// pooled. A line on stderr says so where the first pass, which draws the map,
// had nothing to draw. Nothing where no frame was to be timed (--bench 0).
void stopwatch_print(const Stopwatch *stopwatch, int bench);

#endif
