// What of the scene lies between four planes: how views are fitted.
#ifndef BASE_REGION_H
#define BASE_REGION_H

#include <stdbool.h>

#include "step1_shadowmap/base/scene/scene.h" // Object, Scene
#include "step1_shadowmap/base/system/die.h"  // IF_LINKED

// Four half-spaces dot(normal, p) <= limit, and what is in them: the range
// along the third axis, and how far from the origin it reaches.
typedef struct Region {
    double normals[4][3];
    double limits[4];
    double low, high;
    double farthest;
} Region;

// Sets the range to that of the scene's triangles, as far as they are inside.
// The coordinates are those of a position minus the origin along the axes. With
// nothing inside, low is infinite and high is minus infinity.
void region_include_scene(Region *region, double axes[3][3], const Scene *scene,
                          const double origin[3]);

// A vertex of the object in world axes, minus the origin.
void vertex_relative(const Object *object, const double origin[3],
                     size_t vertex, double position[3]);

// Whether a range holds all of the box around an object, so that none of its
// vertices has to be looked at: `holds` says it of a point along the axes.
// base/leave_out knows.
IF_LINKED bool object_box_is(const Object *object, const double origin[3],
                             double axes[3][3],
                             bool holds(const void *, const double[3]),
                             const void *range);

// A position's coordinates along three axes.
void frame_coordinates(double axes[3][3], const double position[3],
                       double result[3]);

// A triangle gains at most a corner from each half-space that cuts it.
enum { POLYGON_MAX_CORNERS = 20 };

// Keeps what is in the half-space dot(normal, p) <= limit (Sutherland and
// Hodgman). Returns the new number of corners, 0 if nothing is left.
int polygon_clip(double polygon[][3], int count, const double normal[3],
                 double limit);

#endif
