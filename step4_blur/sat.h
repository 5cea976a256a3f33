// Step 4, --sat: a summed-area table in place of the blur. A box of any width
// costs four lookups, so that the width may differ from pixel to pixel.
#ifndef STEP4_SAT_H
#define STEP4_SAT_H

#include "step1_shadowmap/base/gl/gl.h"            // Program
#include "step1_shadowmap/base/system/stopwatch.h" // Touched
#include "step1_shadowmap/map_plan.h"              // MapPlan
#include "step4_blur/sat_compute.h"                // SatCompute

// A table, and the one that the next pass writes.
typedef struct Sat {
    ShaderFiles files;
    SatCompute compute;    // in place of the two programs
    Program start_program; // none: compute shaders sum
    Program sum_program;
    GLuint textures[2]; // of two 32-bit whole numbers; one with compute shaders
    GLuint framebuffers[2][VIEW_MAX_LAYERS];
    int width, height, layers; // 0: there is no table
    int box_width;             // texels, 2 radius + 1
    GLuint steps;              // what 1.0 is in whole numbers
    size_t bytes;
} Sat;

// A table for boxes of up to 2 radius + 1 texels of a map of this size. `by`
// says what sums: compute shaders, fragments, or (auto) compute shaders where
// the driver has them: both make the same numbers. Refuses (status 2) compute
// where it has not.
Sat sat_create(ShaderFiles files, const int size[2], int layers, int radius,
               const char *by);

// Whether compute shaders sum, of what --sat-by says.
bool sat_uses_compute(const char *by);

// Adds what sat_apply touches for so many texels: all of the map's, then of the
// tables that are summed along the other axis, or over and over.
void sat_touch(const Sat *sat, size_t texels, size_t map_texel_bytes,
               Touched *touched);

// Sums the layers of the map (moments in red and green) that the plan draws and
// returns the table, which has sums of these texels alone: what is left of them
// or below counts as 0, so boxes within them come out the same to the last bit.
GLuint sat_apply(const Sat *sat, GLuint map, GLuint empty_vao,
                 const Rect texels[], const MapPlan *plan);

// Sets the uniforms of sat_box.glsl and lookup_sat.glsl.
void sat_set_lookup(const Sat *sat, GLuint program);

// Writes the box's mean at every texel of layer L as directory/blurred.L.exr.
void sat_dump(const Sat *sat, GLuint table, GLuint empty_vao,
              const char *directory);

bool sat_reload(Sat *sat);

void sat_destroy(Sat *sat);

#endif
