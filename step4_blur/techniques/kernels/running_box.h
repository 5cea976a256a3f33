// A box in compute shaders (OpenGL 4.3): a few additions for each texel and
// axis, however wide the box.
#ifndef STEP4_RUNNING_BOX_H
#define STEP4_RUNNING_BOX_H

#include "step1_shadowmap/base/gl/target.h" // Target

// For a box of so many texels before and after the one in the middle. It merges
// texels by the functions of merge_raw.glsl or merge_central.glsl, and rounds
// no number more often than blur.frag would.
Program *running_box_program(Shaders *shaders, const int sides[2]);

// Blurs along one axis (0: u, 1: v): fills each wanted texel of the target, an
// array texture of 32-bit floats, with the mean of the box of texels around it
// in the map that the target reads. Along the axis it also fills up to a box
// more to each side; there the means may be of texels that nobody has drawn.
void running_box_apply(Program *program, Target *target, int axis,
                       const int sides[2]);

#endif
