// Scenes whose visibility is known on paper.
#include "step1_shadowmap/base/scenes/build.h"

#include <math.h> // cos, sin

#include "step1_shadowmap/base/scene/dvec.h" // RADIANS

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
