// What --dump writes: every intermediate map, and run.json that says how it
// was made. The tests recompute each stage from these files.
#ifndef BASE_DUMP_H
#define BASE_DUMP_H

#include "step1_shadowmap/base/leave_out/facts.h"  // Facts
#include "step1_shadowmap/base/system/options.h"   // OptionTable
#include "step1_shadowmap/base/system/stopwatch.h" // Stopwatch
#include "step1_shadowmap/base/light/view.h"       // Views

// Writes directory/name.exr.
void dump_image(const char *directory, const char *name, const float *pixels,
                int width, int height, int channels);

// Writes every layer L of an array texture as directory/name.L.exr.
void dump_layers(const char *directory, const char *name, GLuint texture,
                 int width, int height, int layers, int channels);

typedef struct Run {
    const OptionTable *tables;
    const Facts *facts; // of the scene, its views and what is in them
    const Stopwatch *stopwatch;
    size_t map_bytes; // of all maps that the light's part of the frame needs
} Run;

// Writes run.json into the directory of --dump: the options, the origin and the
// matrices in double, the OpenGL driver and the pass times.
void dump_run(const Run *run);

#endif
