// The receiver's side of the formulas: where it faces, and its depth bias.
#ifndef ORACLE_LIGHT_H
#define ORACLE_LIGHT_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/interval.h"

// dot(a, b) as a 32-bit program may have it, when b was rounded to float.
Interval rounded_dot(const glm::dvec3 &a, const glm::dvec3 &b);

// From the point to the light; for a parallel light of unit length.
glm::dvec3 towards_light(const MapView &view, const glm::dvec3 &point);

// The size of the numbers that a depth t is made of, where coordinates are up
// to `extent`: the share of it by which 32-bit arithmetic can be off counts.
// Of a projected depth: at the stored depth t, 0 being the worst.
double depth_size(const MapView &view, double extent, double t = 0);

enum class Facing { TOWARDS, AWAY, UNKNOWN };

// The sign of N.L; AWAY also outside a spot's cone. UNKNOWN where rounding can
// turn it: |N.L|, or the distance to the cone, within a few units of 0.
Facing facing(const Receiver &receiver, const MapView &view);

double cosine_to_light(const glm::dvec3 &normal, const MapView &view,
                       const glm::dvec3 &point);

// u, v and t all in [0, 1]; outside the map everything is lit.
bool inside_map(const Receiver &receiver);

// dt/du and dt/dv on the plane of a receiver that faces the light. Where the
// light grazes it they are held: at the slope of N.L = 0.02 for a parallel one.
struct PlaneSlopes {
    Interval u, v;
};
PlaneSlopes plane_slopes(const Receiver &receiver, const MapView &view);

// bias + slope-bias (n+1)/2 (|dt/dx| + |dt/dy|), x and y in texels of a map of
// width x height, n the width of the comparison's kernel.
Interval total_bias(const Receiver &receiver, const MapView &view, int width,
                    int height, int n, const Settings &settings);

#endif
