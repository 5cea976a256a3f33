// Step 4, --sat: a summed-area table in place of the blur. A box of any width
// costs four lookups, so that the width may differ from pixel to pixel.
#ifndef STEP4_SAT_H
#define STEP4_SAT_H

#include "step1_shadowmap/base/picture/frame.h" // Frame
#include "step4_blur/sat_compute.h"             // SatCompute

typedef struct Sat {
    SatCompute compute; // in place of the two programs
    Program *start;     // NULL: compute shaders sum
    Program *sum;
    Target table; // of two 32-bit whole numbers: the map's, or sums along rows
    Target sums[2];   // of both axes; with fragments they take turns
    Target *newest;   // that is drawn last
    int doublings[2]; // how often sums are doubled twice along an axis
    int box_width;    // texels, 2 radius + 1
    GLuint steps;     // what 1.0 is in whole numbers
} Sat;

// A table for boxes of up to 2 radius + 1 texels of a map (moments in red and
// green). `by` says what sums: compute shaders, fragments, or (auto) compute
// shaders where the driver has them: both make the same numbers. Refuses
// (status 2) compute where it has not. Returns the table's target. It has sums
// of the wanted texels alone: what is left of them or below counts as 0, so
// boxes within them come out the same to the last bit.
Target *sat_create(Sat *sat, Frame *frame, Target *map, int radius,
                   const char *by);

// Sums the map. With --dump it writes the box's mean at every texel of layer L
// as blurred.L.exr.
void sat_apply(Sat *sat, const Frame *frame);

// Sets the uniforms of sat_box.glsl and lookup_sat.glsl.
void sat_set_lookup(const Sat *sat, GLuint program);

#endif
