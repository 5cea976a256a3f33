// Step 4, --sat: the same table by running sums, in compute shaders (OpenGL
// 4.3): one addition for each texel and axis, where the fragments of recursive
// doubling read four texels log4(n) times.
#ifndef STEP4_SAT_COMPUTE_H
#define STEP4_SAT_COMPUTE_H

#include "step1_shadowmap/base/gl.h" // Program

// None (all zero) where fragments make the table.
typedef struct SatCompute {
    Program rows;
    Program columns;
} SatCompute;

SatCompute sat_compute_create(ShaderFiles files);

// Sums every layer of the map into the table, an array texture of two 32-bit
// whole numbers of the same size; `steps` as in sat.h.
void sat_compute_apply(const SatCompute *compute, GLuint map, GLuint table,
                       const int size[2], int layers, GLuint steps);

bool sat_compute_reload(SatCompute *compute);

void sat_compute_destroy(SatCompute *compute);

#endif
