// Convex parts of space: what the camera sees, what falls into a layer of the
// map. Positions are relative to the camera, in the world's axes.
#ifndef BASE_VOLUME_H
#define BASE_VOLUME_H

#include <stdbool.h>

#include "step1_shadowmap/base/light/view.h" // Views

enum { VOLUME_MAX_PLANES = 12 };

// Half-spaces dot(normal, p) <= limit, all of which hold in it.
typedef struct Volume {
    double normals[VOLUME_MAX_PLANES][3];
    double limits[VOLUME_MAX_PLANES];
    int count;
} Volume;

// The pyramid that the picture shows, without an end to either side.
Volume volume_of_picture(const Views *views);

// Everything that is drawn between two u and two v of a layer, however deep.
Volume volume_of_texels(const Views *views, int layer, const double low[2],
                        const double high[2]);

// What looks a layer up: what it is drawn from, as far as map_layer() of the
// shaders chooses it, or hands over to it, there. A little more than that, for
// the shaders choose in single precision.
Volume volume_of_receivers(const Views *views, int layer);

// Whether a box is outside for certain: all of it beyond one of the planes, by
// more than single precision errs where it is drawn.
bool volume_misses(const Volume *volume, double corners[8][3]);

// Cuts a polygon (see polygon.h); returns how many corners are left.
int volume_clip(const Volume *volume, double polygon[][3], int count);

// t of a position in a layer.
double view_light_depth(const Views *views, int layer,
                        const double position[3]);

// By how much t changes along a way in space, at most; per world unit.
double view_light_steepest(const Views *views, int layer);

// The corners of the box around an object, in world axes, minus the origin.
void object_box(const Object *object, const double origin[3],
                double corners[8][3]);

#endif
