// Step 4: the box of --blur box and boxes in compute shaders (OpenGL 4.3): a
// few additions for each texel and axis, however wide the box.
#ifndef STEP4_RUNNING_BOX_H
#define STEP4_RUNNING_BOX_H

#include "step3_moments/moments.h" // MomentsSettings

// Made of the moments' own way to merge them: no number is rounded more often
// than where fragments add up the whole box. The files' constants say how wide
// that is, as the shader wants it.
Program *running_box_program(Shaders *shaders, const char *constants,
                             const MomentsSettings *moments);

// Fills the wanted texels of the target, an array texture of 32-bit floats, and
// up to a box more to each side along the axis, with the means of the source
// over a box along one axis (0: u, 1: v): so many texels before and after the
// one in the middle. What is filled beside the wanted texels may be of texels
// that nothing has written. The program is in use.
void running_box_apply(GLuint program, GLuint source, Target *target, int axis,
                       const int sides[2]);

#endif
