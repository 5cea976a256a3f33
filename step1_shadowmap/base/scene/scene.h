// The scenes: what there is to see, where the light is, and what casts a
// shadow. Only data; how it is drawn, picture.h says.
#ifndef BASE_SCENE_H
#define BASE_SCENE_H

#include <stdbool.h>
#include <stdio.h> // FILE

#include "step1_shadowmap/base/scene/mesh.h"

enum { SCENE_MAX_OBJECTS = 512, SCENE_MAX_MESHES = 4 };

typedef struct Camera {
    double position[3]; // world space
    double target[3];   // world space, the centre of the picture
    double up[3];       // world space, not parallel to the view direction
    double fov_y;       // whole vertical field of view, radians
    double reach; // view depth where the shadows of splits have faded, world
                  // units; does not change when the camera moves
} Camera;

typedef enum LightKind { LIGHT_DIRECTIONAL, LIGHT_SPOT, LIGHT_POINT } LightKind;

// The depth of a point p in the light's map is a length in world units: for a
// parallel (directional) light dot(direction, p - anchor), that is from the
// plane through the anchor; for a spot and a point light the distance to it.
typedef struct Light {
    LightKind kind;
    double direction[3]; // world space, unit length, the way the light travels;
                         // the axis of a spot's cone
    double anchor[3];    // world space, where depth 0 is; parallel
    double position[3];  // world space; spot and point
    double cone;         // from a spot's axis to its edge, radians
    double reference;    // distance where a spot's or point's radiance holds;
                         // it falls with the square, world units
    double near, far;    // depth range of the map; both 0: fitted to the scene
    float radiance[3];   // linear RGB, of a white surface facing the light
    float ambient[3];    // linear RGB, of a white surface in full shadow
} Light;

typedef struct Object {
    const char *name;
    const Mesh *mesh;       // owned by the scene
    double transform[3][4]; // rows of world_from_object: x' = m[0..2] x + m[3]
    float albedo[3];        // linear RGB
    bool casts; // false: a promise that nothing lies behind it as the light
                // sees it. It is drawn into the map (a receiver has to be),
                // but the map's rectangle is not widened to hold it.
} Object;

typedef struct Scene {
    const char *name;
    Camera camera;
    Light light;
    float background[3]; // linear RGB, where the picture shows no object
    Mesh meshes[SCENE_MAX_MESHES];
    int mesh_count;
    Object objects[SCENE_MAX_OBJECTS];
    int object_count;
} Scene;

// Which objects a pass draws: what its view does not see is not on its list.
// Places in the scene's list of objects, in the order of drawing: where two
// surfaces are equally far, the first one drawn is the one that shows.
typedef struct DrawList {
    int objects[SCENE_MAX_OBJECTS];
    int count;
} DrawList;

// "directional", "spot" or "point".
const char *light_kind_name(LightKind kind);

// Builds the scene that a string like "bleed:r=4,scale=2" names. `light`, a
// kind's name or NULL, replaces the kind of its light: it shines on what the
// camera looks at from the same side, a spot or point light from as far as the
// camera is. Exits with status 2 and one line on stderr for an unknown scene or
// key, or a value out of range. The caller owns the scene until scene_destroy,
// and must not copy it (objects point at its meshes), so it is built in place.
void scene_create(Scene *scene, const char *text, const char *light);

void scene_destroy(Scene *scene);

// Every scene with its keys, their ranges, units and defaults.
void scene_list(FILE *file);

// Every object of the scene.
void draw_list_all(DrawList *list, const Scene *scene);

#endif
