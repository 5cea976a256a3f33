// The built-in scenes: how each is built, and what can be asked of it.
#ifndef BASE_SCENE_TABLE_H
#define BASE_SCENE_TABLE_H

#include "step1_shadowmap/base/scene/scene.h" // Scene

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

// What those need besides; no_more_scenes.c does without.

// Once a light has been raised, or has to be of another kind (NULL: its own):
// a spot or point light shines on what the camera looks at from where it is.
void scene_change_light(Scene *scene, bool raised, const char *kind);

// When all is in its place: dies if a vertex is no number, which would spread
// over all that is fitted to it; says how far shadows reach.
void scene_finish(Scene *scene);

#endif
