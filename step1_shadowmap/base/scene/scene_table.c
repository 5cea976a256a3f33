// The scenes that the lesson is told with.
#include "step1_shadowmap/base/scene/scene_build.h"

// A gate of thin bars: what aliases first in a shadow map.
static void add_gate(Scene *scene, const Mesh *box)
{
    const double post[3] = {0.035, 1.0, 0.035};
    for (int i = 0; i < 6; i++) {
        const double position[3] = {-1.62, 0.5, -0.35 + 0.22 * i};
        object_set_albedo(scene_add_object(scene, "bar", box, post, position),
                          0.16f, 0.20f, 0.24f);
    }
    const double rail[3] = {0.035, 0.05, 1.25};
    const double place[3] = {-1.62, 0.975, 0.2};
    object_set_albedo(scene_add_object(scene, "rail", box, rail, place), 0.16f,
                      0.20f, 0.24f);
}

void scene_build_teapot(Scene *scene, const double values[])
{
    (void)values;
    scene_set_default_view(scene);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const Mesh *box = scene_add_mesh(scene, mesh_box());

    const double one[3] = {1.1, 1.1, 1.1};
    // The pot's bottom is domed: its edge is above its middle by 0.05.
    const double middle[3] = {0, -0.05, 0};
    const Mesh *teapot = scene_add_mesh(scene, mesh_teapot(16));
    object_set_albedo(scene_add_object(scene, "teapot", teapot, one, middle),
                      0.72f, 0.30f, 0.16f);
    const double wall[3] = {0.14, 1.0, 2.2};
    const double behind[3] = {1.75, 0.5, -0.3};
    object_set_albedo(scene_add_object(scene, "wall", box, wall, behind), 0.52f,
                      0.56f, 0.60f);
    add_gate(scene, box);
}

const SceneEntry scene_table[] = {
    {"teapot",
     "a teapot on a floor, with a wall and thin bars",
     scene_build_teapot,
     {{0}}},
    {.name = NULL},
};
