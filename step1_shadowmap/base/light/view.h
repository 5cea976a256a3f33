// Where the picture is seen from, and where the light sees it from. All
// matrices map positions *relative to the camera* (world minus origin, the
// world's axes) and are made in double: far from the world's origin, single
// precision would have no digits left for the scene.
#ifndef BASE_VIEW_H
#define BASE_VIEW_H

#include "step1_shadowmap/base/gl/target.h"   // Rect
#include "step1_shadowmap/base/scene/scene.h" // DrawList, Scene

enum { VIEW_MAX_LAYERS = 8 }; // splits, which are more than a point's 6

// What the light sees in one layer of its map. The rows of map_from_relative
// give (u w, v w, z w, w) of a relative position: u and v in [0, 1] across the
// map, u to the right and v up; z in [0, 1] is for the depth test. For a
// parallel light w is 1 and z is t; for a spot and a point light w is the
// distance along the view's axis.
//
// The depth t in [0, 1] is linear from near to far, for every kind of light
//   t = dot(depth_from_relative, (p, 1)) + depth_per_distance |p - light|:
// along a parallel light's direction (its depth_per_distance is 0), else the
// distance from the light (only the last number of the row is not 0).
typedef struct LightView {
    double map_from_relative[4][4];
    double depth_from_relative[4];
    double near, far; // see Light, world units
    // Of a split: the view depth where it ends, and where it begins to hand
    // over to the next one, world units. 0 where there are no splits.
    double handover, end;
    DrawList seen;  // what is drawn into the layer
    Rect looked_up; // the texels that receivers in the picture lie in
} LightView;

typedef struct Views {
    double origin[3]; // the camera's position, world space
    double clip_from_relative[4][4];
    DrawList seen; // what may be in the picture, and is drawn into it
    // Relative to the origin, and 1; of a parallel light the unit vector
    // towards it, and 0.
    double light_position[4];
    double depth_per_distance;
    LightView light[VIEW_MAX_LAYERS];
    int layers;
    int width, height; // of the map, texels
    int border; // texels at each edge that no caster reaches and no receiver
                // looks up, but those outside a parallel light's casters
} Views;

typedef struct ViewsSize ViewsSize;

// Sets the layers, their matrices and depths, and the light's position; origin,
// map size and border have been set.
typedef void ViewsFit(Views *views, const Scene *scene, const ViewsSize *size);

struct ViewsSize {
    int picture[2]; // pixels
    int map[2];     // texels of a layer
    ViewsFit *fit;  // NULL: a parallel light's one view
};

// Fits the views to the scene. Everything is drawn into each and looked up.
// `reach` is how many texels a filter reads to each side. Texels are square in
// the world. The border is at least twice the reach: a receiver within reach of
// a caster must not have the map's edge within reach too, or the far depth
// outside would join the caster and the receiver under its filter. It is at
// least a 16th of the map, so that filters of different width see the same
// texels.
void views_fit(Views *views, const Scene *scene, const ViewsSize *size,
               int reach);

// Rounds a matrix to single precision and sets a mat4 uniform of the program.
void view_set_matrix(GLuint program, const char *name,
                     const double matrix[4][4]);

// Sets the uniforms of light_depth.glsl, and map_from_relative, an array of
// mat4 with an element for each layer.
void view_set_light(GLuint program, const Views *views);

#endif
