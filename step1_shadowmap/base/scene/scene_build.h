// What the built-in scenes are built with, and the table of them.
#ifndef BASE_SCENE_BUILD_H
#define BASE_SCENE_BUILD_H

#include "step1_shadowmap/base/scene/scene.h" // Scene, Object, LightKind, Mesh

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

// A directional light that travels along x, y, z (of any length).
void scene_set_light(Scene *scene, double x, double y, double z);

// The whole vertical field of view is in degrees.
void scene_set_camera(Scene *scene, const double position[3],
                      const double target[3], double degrees);

// The camera and the light of the teapot and of scenes like it.
void scene_set_default_view(Scene *scene);

// Also of scenes that change it.
void scene_build_teapot(Scene *scene, const double values[]);

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

// The lesson's, and those of base/scenes.
extern const SceneEntry scene_table[], more_scenes[];

// base/scenes has these; no_more_scenes.c does without: the keys of every
// scene, and what they and another kind of light (NULL: its own) change of a
// scene.
extern const SceneKey more_keys[SCENE_MAX_KEYS];
void scene_change(Scene *scene, const double values[], const char *kind);

#endif
