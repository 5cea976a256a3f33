// Step 3: two moments of the depth in place of the depth.
#ifndef STEP3_MOMENTS_H
#define STEP3_MOMENTS_H

#include "step1_shadowmap/shadow_map.h" // shadow_map_draw_layer

// --show mean and --show variance.
extern const ShowMode moments_shows[];

// The shader files that draw the map, NULL at the end.
extern const char *const moments_shaders[];

// A shadow map of two channels, M1 = t and M2 = t^2 of the depths t in [0, 1],
// in 32-bit floats. Unlike depths, moments may be averaged: the map is looked
// up bilinearly. Outside is far depth.
typedef struct Moments {
    Target target;
    Program *program;
} Moments;

// `looked_up`: how many texels the picture itself reads to each side, or 0.
void moments_create(Moments *moments, Frame *frame, int looked_up);

void moments_draw(Moments *moments, const Frame *frame);

#endif
