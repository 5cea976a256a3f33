// Step 4, --sat: the same table by running sums, in compute shaders (OpenGL
// 4.3): one addition for each texel and axis, where the fragments of recursive
// doubling read four texels log4(n) times.
#ifndef STEP4_SAT_COMPUTE_H
#define STEP4_SAT_COMPUTE_H

#include "step1_shadowmap/base/gl/gl.h" // Program
#include "step1_shadowmap/map_plan.h"   // MapPlan

// None (all zero) where fragments make the table.
typedef struct SatCompute {
    Program rows;
    Program columns;
} SatCompute;

SatCompute sat_compute_create(ShaderFiles files);

// Sums these texels of the layers that the plan draws into the table, an array
// texture of two 32-bit whole numbers of the map's size; `steps` as in sat.h.
void sat_compute_apply(const SatCompute *compute, GLuint map, GLuint table,
                       int layers, GLuint steps, const Rect texels[],
                       const MapPlan *plan);

bool sat_compute_reload(SatCompute *compute);

void sat_compute_destroy(SatCompute *compute);

#endif
