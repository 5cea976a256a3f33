// What the built-in scenes are built with.
#ifndef BASE_SCENE_BUILD_H
#define BASE_SCENE_BUILD_H

#include "step1_shadowmap/base/scene/scene.h" // Scene, Object, LightKind, Mesh

// The scene owns the mesh from here on. Dies if it holds too many.
const Mesh *scene_add_mesh(Scene *scene, Mesh mesh);

// A grey object whose axes are scaled and which stands at a position; it
// casts. Dies if the scene holds too many.
Object *scene_add_object(Scene *scene, const char *name, const Mesh *mesh,
                         const double size[3], const double position[3]);

// A plane perpendicular to the light, `along` further than the anchor and
// shifted within the plane; its sides are turned by `angle` (radians) about
// the light against the horizontal.
Object *scene_add_facing_plane(Scene *scene, const char *name, const Mesh *mesh,
                               double along, const double shift[2],
                               const double size[2], double angle);

// A floor at height 0, 60 units wide, that casts nothing.
Object *scene_add_floor(Scene *scene, const Mesh *plane);

// Linear RGB.
void object_set_albedo(Object *object, float red, float green, float blue);

// A directional light that travels along x, y, z (of any length).
void scene_set_light(Scene *scene, double x, double y, double z);

// The whole vertical field of view is in degrees.
void scene_set_camera(Scene *scene, const double position[3],
                      const double target[3], double degrees);

// The camera and the light of the teapot and of scenes like it.
void scene_set_default_view(Scene *scene);

// Also of scenes that change it.
void scene_build_teapot(Scene *scene, const double values[]);

#endif
