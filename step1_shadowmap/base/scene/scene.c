#include "step1_shadowmap/base/scene/scene.h"

#include <string.h> // memcpy, memset, strcmp

#include "step1_shadowmap/base/scene/scene_build.h" // scene_add_object
#include "step1_shadowmap/base/system/die.h"        // die_usage

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

void scene_build_teapot(Scene *scene)
{
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

void scene_list(FILE *file)
{
    fprintf(file, "teapot  a teapot on a floor, with a wall and thin bars\n");
    if (more_scenes_list != NULL) {
        more_scenes_list(file);
    }
}

void scene_create(Scene *scene, const char *text, const char *light)
{
    const float sky[3] = {0.36f, 0.44f, 0.55f};
    memset(scene, 0, sizeof *scene);
    memcpy(scene->background, sky, sizeof sky);
    bool known = strcmp(text, "teapot") == 0;
    if (more_scenes_create != NULL) {
        known = more_scenes_create(scene, text, light);
    } else if (known) {
        scene->name = text;
        scene_build_teapot(scene);
    }
    if (!known) {
        die_usage("--scene '%s': there is no such scene; see --list-scenes",
                  text);
    }
}

void scene_destroy(Scene *scene)
{
    for (int i = 0; i < scene->mesh_count; i++) {
        mesh_destroy(&scene->meshes[i]);
    }
    memset(scene, 0, sizeof *scene);
}

void draw_list_all(DrawList *list, const Scene *scene)
{
    list->count = scene->object_count;
    for (int i = 0; i < scene->object_count; i++) {
        list->objects[i] = i;
    }
}
