// Scenes whose visibility is known on paper.
#include "step1_shadowmap/base/scenes/build.h"

#include <math.h> // cos, sin

#include "step1_shadowmap/base/scene/dvec.h" // RADIANS

// The floor at depth 0.9 of a range of 10 units, the occluder `gap` of the
// range above it. The light is along no axis of the world, and the occluder's
// sides along no axis of the map.
enum { EDGE_GAP };

void scene_build_edge(Scene *scene, const double values[])
{
    const double range = 10;
    const double eye[3] = {5.0, 5.5, 4.5};
    const double target[3] = {0.1, 0.5, 0.1};
    scene_set_camera(scene, eye, target, 24);
    scene_set_light(scene, -0.35, -0.9, -0.25);
    for (int k = 0; k < 3; k++) {
        scene->light.anchor[k] = -0.9 * range * scene->light.direction[k];
    }
    scene->light.far = range;
    const Mesh *plane = scene_add_mesh(scene, mesh_plane());
    const double centre[2] = {0, 0};
    const double large[2] = {40, 40};
    Object *ground = scene_add_facing_plane(scene, "floor", plane, 0.9 * range,
                                            centre, large, 0);
    object_set_albedo(ground, 0.62f, 0.60f, 0.57f);
    ground->casts = false;
    const double size[2] = {2, 1.5};
    Object *occluder = scene_add_facing_plane(scene, "occluder", plane,
                                              (0.9 - values[EDGE_GAP]) * range,
                                              centre, size, 0.35);
    object_set_albedo(occluder, 0.25f, 0.42f, 0.62f);
}

// Two occluders over a floor, all perpendicular to the light; the upper one
// ends above the middle of the lower one, whose shadow therefore contains an
// edge that it should not show. The upper gap is r times the lower one.
enum { BLEED_RATIO };

void scene_build_bleed(Scene *scene, const double values[])
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

void scene_build_empty(Scene *scene, const double values[])
{
    (void)values;
    scene_set_default_view(scene);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
}

void scene_build_grazing(Scene *scene, const double values[])
{
    (void)values;
    const double degrees = 2;
    scene_set_default_view(scene);
    scene_set_light(scene, cos(RADIANS(degrees)), -sin(RADIANS(degrees)), 0);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
}

// The light shines straight up from below the floor: nothing that the camera
// sees faces it.
void scene_build_unlit(Scene *scene, const double values[])
{
    (void)values;
    scene_set_default_view(scene);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    const double size[3] = {0.8, 0.8, 0.8};
    const double place[3] = {0, 0.4, 0};
    object_set_albedo(scene_add_object(scene, "block", box, size, place), 0.72f,
                      0.30f, 0.16f);
    scene_set_light(scene, 0, 1, 0);
}

// Everything that casts is behind the camera, and so is its shadow.
void scene_build_offstage(Scene *scene, const double values[])
{
    (void)values;
    scene_set_default_view(scene);
    scene_set_light(scene, 0.4, -0.7, 0.5);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const double size[3] = {1, 1, 1};
    const double behind[3] = {0, 0, 12};
    scene_add_object(scene, "teapot", scene_add_mesh(scene, mesh_teapot(16)),
                     size, behind);
}
