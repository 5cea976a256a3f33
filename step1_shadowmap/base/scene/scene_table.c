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

// Two occluders over a floor, all perpendicular to the light; the upper one
// ends above the middle of the lower one, whose shadow therefore contains an
// edge that it should not show. The upper gap is r times the lower one.
enum { BLEED_RATIO };
static void build_bleed(Scene *scene, const double values[])
{
    const double lower_gap = 0.6;
    const double upper_gap = values[BLEED_RATIO] * lower_gap;
    const double height = 1 + lower_gap + upper_gap;
    const double eye[3] = {6.2, 2.2, 3.2};
    const double target[3] = {0.1, 0.8, 0};
    scene_set_camera(scene, eye, target, 28);
    scene_set_light(scene, -0.12, -0.98, -0.08);
    for (int k = 0; k < 3; k++) {
        scene->light.anchor[k] = -height * scene->light.direction[k];
    }
    const Mesh *plane = scene_add_mesh(scene, mesh_plane());
    const double centre[2] = {0, 0};
    const double large[2] = {40, 40};
    Object *ground =
        scene_add_facing_plane(scene, "floor", plane, height, centre, large, 0);
    object_set_albedo(ground, 0.62f, 0.60f, 0.57f);
    ground->casts = false;
    const double aside[2] = {-0.5, 0};
    const double size[2] = {2, 2};
    object_set_albedo(scene_add_facing_plane(scene, "lower", plane,
                                             height - lower_gap, centre, size,
                                             0.1),
                      0.25f, 0.42f, 0.62f);
    object_set_albedo(
        scene_add_facing_plane(scene, "upper", plane, 1, aside, size, 0.1),
        0.72f, 0.30f, 0.16f);
}

const SceneEntry scene_table[] = {
    {"teapot",
     "a teapot on a floor, with a wall and thin bars",
     scene_build_teapot,
     {{0}}},
    {"bleed",
     "two occluders above a floor: light bleeding",
     build_bleed,
     {{"r", 0.05, 50, 2, "upper gap over lower gap"}}},
    {.name = NULL},
};
