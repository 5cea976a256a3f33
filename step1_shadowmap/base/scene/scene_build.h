// What the built-in scenes are built with, and their builders. A builder fills
// a zeroed scene; its values are those of the scene's keys (scene_table.c).
#ifndef BASE_SCENE_BUILD_H
#define BASE_SCENE_BUILD_H

#include "step1_shadowmap/base/scene/scene.h" // Scene, Object, LightKind, Mesh

// The scene owns the mesh from here on. Dies if it holds too many.
const Mesh *scene_add_mesh(Scene *scene, Mesh mesh);

// A grey object whose axes are scaled and which stands at a position; it
// casts. Dies if the scene holds too many.
Object *scene_add_object(Scene *scene, const char *name, const Mesh *mesh,
                         const double size[3], const double position[3]);

// A box that stands on a height: `foot` is the middle of its bottom.
Object *scene_add_block(Scene *scene, const char *name, const Mesh *box,
                        const double size[3], const double foot[3]);

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

// A spot or point light that is aimed at a target; its radiance holds at the
// distance `reference` from it.
void scene_set_local_light(Scene *scene, LightKind kind,
                           const double position[3], const double target[3],
                           double reference);

// The whole vertical field of view is in degrees.
void scene_set_camera(Scene *scene, const double position[3],
                      const double target[3], double degrees);

// The camera and the light of the teapot and of scenes like it.
void scene_set_default_view(Scene *scene);

// scene_daylight.c
void scene_build_teapot(Scene *scene, const double values[]);
void scene_build_thin(Scene *scene, const double values[]);
void scene_build_fence(Scene *scene, const double values[]);
void scene_build_avenue(Scene *scene, const double values[]);
void scene_build_crowd(Scene *scene, const double values[]);

// scene_closed.c
void scene_build_edge(Scene *scene, const double values[]);
void scene_build_bleed(Scene *scene, const double values[]);
void scene_build_empty(Scene *scene, const double values[]);
void scene_build_grazing(Scene *scene, const double values[]);
void scene_build_unlit(Scene *scene, const double values[]);
void scene_build_offstage(Scene *scene, const double values[]);

// scene_lamps.c
void scene_build_stage(Scene *scene, const double values[]);
void scene_build_room(Scene *scene, const double values[]);

// scene_extreme.c
void scene_build_lamp(Scene *scene, const double values[]);
void scene_build_enclosed(Scene *scene, const double values[]);
void scene_build_headlamp(Scene *scene, const double values[]);
void scene_build_overhead(Scene *scene, const double values[]);
void scene_build_coplanar(Scene *scene, const double values[]);
void scene_build_slivers(Scene *scene, const double values[]);
void scene_build_broken(Scene *scene, const double values[]);
void scene_build_cut(Scene *scene, const double values[]);
void scene_build_stiff(Scene *scene, const double values[]);
void scene_build_speck(Scene *scene, const double values[]);

#endif
