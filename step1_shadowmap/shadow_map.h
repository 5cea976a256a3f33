// Step 1: the scene as the light sees it, in a texture.
#ifndef STEP1_SHADOW_MAP_H
#define STEP1_SHADOW_MAP_H

#include "step1_shadowmap/base/picture/frame.h"  // Frame
#include "step1_shadowmap/base/system/options.h" // Option

// Against self-shadowing, for every step that compares depths.
typedef struct BiasSettings {
    double constant; // of the depth range
    double slope;    // of the depth change across half the comparison kernel
} BiasSettings;

extern const Option bias_options[];

BiasSettings bias_settings(void);

// Sets the uniforms of bias.glsl in the program that is in use.
void bias_apply(const BiasSettings *settings, GLuint program);

// How a picture looks its map up that compares with biased depths (see Lookups
// in base/picture/frame.h): it reads up to `reach` texels to each side, one of
// them for the rounding of u and v, and compares kernel x kernel of them.
Lookups bias_lookups(const BiasSettings *settings, int reach, int kernel);

typedef struct ShadowMap {
    Target target; // depths t in [0, 1], a layer for each view of the light
    Program *program;
} ShadowMap;

// `reach`: how many texels the picture reads of it to each side.
void shadow_map_create(ShadowMap *map, Frame *frame, int reach);

void shadow_map_draw(ShadowMap *map, const Frame *frame);

// Draws the scene as the light sees it in one layer, if somebody wants that
// layer. The program writes what a texel keeps of map_depth(); a texel that no
// surface covers is at far depth.
void shadow_map_draw_layer(Target *target, Program *program, const Frame *frame,
                           int layer);

#endif
