// A box in compute shaders (OpenGL 4.3): a few additions for each texel and
// axis, however wide the box.
#ifndef STEP4_RUNNING_BOX_H
#define STEP4_RUNNING_BOX_H

#include "step1_shadowmap/base/gl/target.h" // Target

// For a box of so many texels before and after the one in the middle. Made of
// the moments' own way to merge them: no number is rounded more often than
// where fragments add up the whole box.
Program *running_box_program(Shaders *shaders, const int sides[2]);

// Fills the wanted texels of the target, an array texture of 32-bit floats, and
// up to a box more to each side along the axis, with the means of what it reads
// over a box along one axis (0: u, 1: v). What is filled beside the wanted
// texels may be of texels that nothing has written.
void running_box_apply(Program *program, Target *target, int axis,
                       const int sides[2]);

#endif
