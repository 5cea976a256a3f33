// The scenes of the lesson alone.
#include "step1_shadowmap/base/scene/scene_build.h"

__attribute__((weak)) const SceneEntry more_scenes[] = {{.name = NULL}};

__attribute__((weak)) const SceneKey more_keys[SCENE_MAX_KEYS] = {{0}};

__attribute__((weak)) void scene_change(Scene *scene, const double values[],
                                        const char *kind)
{
    (void)scene, (void)values, (void)kind;
}
