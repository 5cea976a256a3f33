// Where the picture is seen from, and where the light sees it from. All
// matrices map positions *relative to the camera* (world minus origin, the
// world's axes) and are made in double: far from the world's origin, single
// precision would have no digits left for the scene.
#ifndef BASE_VIEW_H
#define BASE_VIEW_H

#include <glad/gl.h>

#include "step1_shadowmap/base/scene.h"

enum { VIEW_MAX_LAYERS = 8 };

// What the light sees in one layer of its map. (u, v, t) of a position: u and
// v in [0, 1] across the map, u to the right and v up; t in [0, 1] is the
// depth along the light, linear from near to far.
typedef struct LightView {
    double map_from_relative[4][4]; // rows; the last one is 0 0 0 1
    double near, far;               // dot(direction, p - anchor), world units
} LightView;

typedef struct Views {
    double origin[3]; // the camera's position, world space
    double clip_from_relative[4][4];
    LightView light[VIEW_MAX_LAYERS];
    int layers;
    int width, height; // of the map, texels
    int border;        // texels at each edge that no caster reaches
} Views;

// Fits the views to the scene. `picture` and `map` are sizes in pixels and
// texels; `reach` is how many texels a filter reads to each side. Texels are
// square in the world. The border is at least twice the reach: a receiver
// within reach of a caster must not have the map's edge within reach too, or
// the far depth outside would join the caster and the receiver under its
// filter. It is at least a 16th of the map, so that filters of different width
// see the same texels.
void views_fit(Views *views, const Scene *scene, const int picture[2],
               const int map[2], int reach);

// Rounds a matrix to single precision and sets a mat4 uniform of the program.
void view_set_matrix(GLuint program, const char *name,
                     const double matrix[4][4]);

// Sets element `layer` of the program's uniform map_from_relative, an array of
// mat4, and its uniform int layer.
void view_set_layer(GLuint program, const Views *views, int layer);

#endif
