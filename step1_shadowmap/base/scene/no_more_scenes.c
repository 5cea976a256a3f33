// The scenes of the lesson alone.
#include "step1_shadowmap/base/scene/scene_build.h"

__attribute__((weak)) const SceneEntry more_scenes[] = {{.name = NULL}};

__attribute__((weak)) void scene_change_light(Scene *scene, bool raised,
                                              const char *kind)
{
    (void)scene, (void)raised, (void)kind;
}

__attribute__((weak)) void scene_finish(Scene *scene)
{
    (void)scene;
}
