// A run of a program, from its options to its files. main.c owns the loop:
//     while (run_next(&run)) { draw }
#ifndef BASE_RUN_H
#define BASE_RUN_H

#include "step1_shadowmap/base/gl/context.h"      // Context
#include "step1_shadowmap/base/picture/picture.h" // Picture
#include "step1_shadowmap/base/run/window.h"      // Window

typedef struct Run {
    Frame frame; // what the stages are given
    Context context;
    int drawn; // frames
    Picture *picture;
    Window window;
} Run;

// Reads the command line into the settings that the tables name (the last has
// NULL options) and those that every step has; see options_parse.
void run_options(Run *run, int argc, char **argv, int step, const char *program,
                 const ShowMode *more_shows, const OptionTable tables[]);

// Once the stages have looked at their options too: makes the scene and the
// OpenGL context.
void run_begin(Run *run);

// Once the frame's lookups are known: fits the light's views, with room for
// them.
void run_look(Run *run);

// Whether there is a frame to draw: one, or those of --bench, or of --window
// until it is closed, whose title says the `subject`. With --dump another one,
// for the maps alone. Writes --output and the picture's files of --dump after
// the last frame that draws it.
bool run_next(Run *run, Picture *picture, const char *subject, ...)
    __attribute__((format(printf, 3, 4)));

// Writes the maps of --dump, prints the times of --bench, and frees everything.
void run_end(Run *run);

#endif
