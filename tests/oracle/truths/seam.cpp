#include "tests/oracle/truths/seam.h"

#include <cmath> // abs

#include "tests/oracle/lib/verdict.h" // BadInput

static int face_towards(const glm::dvec3 &direction)
{
    int axis = 0;
    for (int k : {1, 2})
        if (std::abs(direction[k]) > std::abs(direction[axis]))
            axis = k;
    return 2 * axis + (direction[axis] < 0 ? 1 : 0);
}

// At distance 1 along the face's axis W the edge is at 1 across it. There u
// changes by the length of U - W / 2, which is across the axis, per unit.
static Seam seam_along(const glm::dvec4 &row, const glm::dvec3 &axis,
                       const glm::dvec3 &from_light, int size)
{
    glm::dvec3 across = glm::dvec3(row) - 0.5 * axis;
    double per_unit = glm::length(across);
    double tangent =
        glm::dot(across, from_light) / per_unit / glm::dot(axis, from_light);
    return {(1 - std::abs(tangent)) * per_unit * size,
            face_towards(tangent < 0 ? -across : across)};
}

Seam nearest_seam(const Receiver &receiver, const MapView &view)
{
    if (view.lamp != Lamp::POINT)
        throw BadInput("seams: only a point light's map has them");
    glm::dvec3 axis(view.rows[3]);
    glm::dvec3 from_light = receiver.position - view.position;
    Seam u = seam_along(view.rows[0], axis, from_light, view.width);
    Seam v = seam_along(view.rows[1], axis, from_light, view.height);
    return u.texels < v.texels ? u : v;
}
