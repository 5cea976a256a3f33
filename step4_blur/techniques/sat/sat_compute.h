// Step 4, --sat: the same table by running sums, in compute shaders (OpenGL
// 4.3): one addition for each texel and axis, where the fragments of recursive
// doubling read four texels log4(n) times.
#ifndef STEP4_SAT_COMPUTE_H
#define STEP4_SAT_COMPUTE_H

#include "step1_shadowmap/base/gl/target.h" // Target

typedef struct SatCompute {
    Program *rows;
    Program *columns;
} SatCompute;

SatCompute sat_compute_create(Shaders *shaders);

// Sums the wanted texels of the map along the rows into the table, and this
// along the columns into `sums`, which has the same texture: two 32-bit whole
// numbers for each texel; `steps` as in sat.c.
void sat_compute_apply(const SatCompute *compute, GLuint map, Target *table,
                       Target *sums, GLuint steps);

#endif
