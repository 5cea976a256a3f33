// Step 4: the box of --blur box and boxes in compute shaders (OpenGL 4.3): a
// few additions for each texel and axis, however wide the box.
#ifndef STEP4_RUNNING_BOX_H
#define STEP4_RUNNING_BOX_H

#include "step1_shadowmap/map_plan.h" // MapPlan, Rect
#include "step3_moments/moments.h"    // MomentsSettings

// Made of the moments' own way to merge them: no number is rounded more often
// than where fragments add up the whole box. The files' constants say how wide
// that is, as the shader wants it.
Program running_box_program(ShaderFiles files, const MomentsSettings *moments);

// Fills these texels of the layers that the plan draws, by layer, and up to a
// box more to each side along the axis. The target is an array texture of
// 32-bit floats; it gets the means of the source over a box along one axis (0:
// u, 1: v): so many texels before and after the one in the middle. What is
// filled beside the texels asked for may be of texels that nothing has written.
void running_box_apply(GLuint program, GLuint source, GLuint target,
                       const Rect texels[], const MapPlan *plan, int axis,
                       const int sides[2]);

#endif
