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

extern const SceneEntry scene_table[];

#endif
