// What more scenes need than those of the lesson, and their builders. A builder
// fills a zeroed scene; its values are those of the scene's keys (table.c).
#ifndef BASE_SCENES_BUILD_H
#define BASE_SCENES_BUILD_H

#include "step1_shadowmap/base/scene/scene_build.h" // scene_add_object, ...

// mesh_plane() of side x side smaller squares. A rasteriser's positions inside
// a triangle are as exact as a float as large as the triangle, so where a large
// floor has to be flat to the last bits it is laid in tiles.
Mesh mesh_tiles(int side);

// A sphere of radius 1 at the origin, smooth normals; `segments` around the
// equator and segments / 2 from pole to pole, at least 4.
Mesh mesh_sphere(int segments);

// A box that stands on a height: `foot` is the middle of its bottom.
Object *scene_add_block(Scene *scene, const char *name, const Mesh *box,
                        const double size[3], const double foot[3]);

enum { SCENE_MAX_KEYS = 4 };

typedef struct SceneKey {
    const char *name;
    double minimum, maximum, value; // the value is the default
    const char *help;
} SceneKey;

typedef struct SceneEntry {
    const char *name; // NULL ends the table
    const char *help;
    // Fills a zeroed scene; values are those of the keys, in their order.
    void (*build)(Scene *scene, const double values[]);
    SceneKey keys[SCENE_MAX_KEYS];
} SceneEntry;

// The first one is the lesson's.
extern const SceneEntry scene_table[];

// The keys of every scene, and what they and another kind of light (NULL: its
// own) change of a scene.
extern const SceneKey more_keys[SCENE_MAX_KEYS];
void scene_change(Scene *scene, const double values[], const char *kind);

// Once a light has been raised, or has to be of another kind (NULL: its own):
// a spot or point light shines on what the camera looks at from where it is.
void scene_change_light(Scene *scene, bool raised, const char *kind);

// A plane perpendicular to the light, `along` further than the anchor and
// shifted within the plane; its sides are turned by `angle` (radians) about
// the light against the horizontal.
Object *scene_add_facing_plane(Scene *scene, const char *name, const Mesh *mesh,
                               double along, const double shift[2],
                               const double size[2], double angle);

// A spot or point light that is aimed at a target; its radiance holds at the
// distance `reference` from it.
void scene_set_local_light(Scene *scene, LightKind kind,
                           const double position[3], const double target[3],
                           double reference);

// daylight.c
void scene_build_thin(Scene *scene, const double values[]);
void scene_build_fence(Scene *scene, const double values[]);
void scene_build_avenue(Scene *scene, const double values[]);
void scene_build_crowd(Scene *scene, const double values[]);

// closed.c
void scene_build_edge(Scene *scene, const double values[]);
void scene_build_bleed(Scene *scene, const double values[]);
void scene_build_empty(Scene *scene, const double values[]);
void scene_build_grazing(Scene *scene, const double values[]);
void scene_build_unlit(Scene *scene, const double values[]);
void scene_build_offstage(Scene *scene, const double values[]);

// lamps.c
void scene_build_stage(Scene *scene, const double values[]);
void scene_build_room(Scene *scene, const double values[]);

// extreme.c
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
