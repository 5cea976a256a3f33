// Which sides of a surface can be lit at all.
#ifndef BASE_FACING_H
#define BASE_FACING_H

#include <stdbool.h>

#include "step1_shadowmap/base/light/view.h" // Views

// What is known of one object's normals.
typedef struct Facing {
    const Views *views;
    double normal_from_object[3][3]; // to the world's axes, of any length
    // The same with every product and sum of it taken of magnitudes: times a
    // few roundings, the most by which single precision can be off.
    double magnitude[3][3];
} Facing;

Facing facing_of_object(const Object *object, const Views *views);

// Whether some point of a triangle may have a normal, on the side that the
// camera sees, which faces the light. `positions` are relative to the camera,
// `across` their plane's normal by the order of the corners.
bool facing_may_be_lit(const Facing *facing, const Mesh *mesh,
                       const uint32_t corners[3], double positions[][3],
                       const double across[3]);

#endif
