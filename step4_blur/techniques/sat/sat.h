// The table's numbers.
#ifndef STEP4_SAT_H
#define STEP4_SAT_H

#include "step1_shadowmap/base/gl/gl.h" // GLuint

// What 1.0 is in whole numbers, in a table for boxes of up to so many texels
// along each axis.
GLuint sat_steps(int box_width);

#endif
