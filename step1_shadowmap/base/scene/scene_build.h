// What the built-in scenes are built with.
#ifndef BASE_SCENE_BUILD_H
#define BASE_SCENE_BUILD_H

#include "step1_shadowmap/base/scene/scene.h" // Scene, Object, LightKind, Mesh
#include "step1_shadowmap/base/system/die.h"  // IF_LINKED

// The scene owns the mesh from here on. Dies if it holds too many.
const Mesh *scene_add_mesh(Scene *scene, Mesh mesh);

// A grey object whose axes are scaled and which stands at a position; it
// casts. Dies if the scene holds too many.
Object *scene_add_object(Scene *scene, const char *name, const Mesh *mesh,
                         const double size[3], const double position[3]);

// A floor at height 0, 60 units wide, that casts nothing.
Object *scene_add_floor(Scene *scene, const Mesh *plane);

// Linear RGB.
void object_set_albedo(Object *object, float red, float green, float blue);

// A parallel light that travels along x, y, z (of any length).
void scene_set_light(Scene *scene, double x, double y, double z);

// The whole vertical field of view is in degrees.
void scene_set_camera(Scene *scene, const double position[3],
                      const double target[3], double degrees);

// The camera and the light of the teapot and of scenes like it.
void scene_set_default_view(Scene *scene);

// Also of scenes that change it.
void scene_build_teapot(Scene *scene);

// base/scenes has more; each has keys, and every scene has some more.
IF_LINKED void more_scenes_list(FILE *file);

// Also the teapot, as its keys and another kind of light change it (see
// scene_create). False: there is no such scene.
IF_LINKED bool more_scenes_create(Scene *scene, const char *text,
                                  const char *light);

#endif
