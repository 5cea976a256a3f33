#include "step1_shadowmap/base/scene/scene_build.h"

#include <string.h> // memcpy

#include "step1_shadowmap/base/system/die.h" // die
#include "step1_shadowmap/base/scene/dvec.h" // dvec_copy, dvec_normalize, RADIANS

const Mesh *scene_add_mesh(Scene *scene, Mesh mesh)
{
    if (scene->mesh_count == SCENE_MAX_MESHES) {
        die("more than %d meshes in a scene", SCENE_MAX_MESHES);
    }
    mesh_find_box(&mesh);
    scene->meshes[scene->mesh_count] = mesh;
    return &scene->meshes[scene->mesh_count++];
}

Object *scene_add_object(Scene *scene, const char *name, const Mesh *mesh,
                         const double size[3], const double position[3])
{
    if (scene->object_count == SCENE_MAX_OBJECTS) {
        die("more than %d objects in a scene", SCENE_MAX_OBJECTS);
    }
    Object *object = &scene->objects[scene->object_count++];
    *object = (Object){.name = name,
                       .mesh = mesh,
                       .albedo = {0.6f, 0.6f, 0.6f},
                       .casts = true};
    for (int k = 0; k < 3; k++) {
        object->transform[k][k] = size[k];
        object->transform[k][3] = position[k];
    }
    return object;
}

Object *scene_add_floor(Scene *scene, const Mesh *plane)
{
    const double size[3] = {60, 1, 60};
    const double position[3] = {0, 0, 0};
    Object *ground = scene_add_object(scene, "floor", plane, size, position);
    object_set_albedo(ground, 0.62f, 0.60f, 0.57f);
    ground->casts = false;
    return ground;
}

void object_set_albedo(Object *object, float red, float green, float blue)
{
    object->albedo[0] = red;
    object->albedo[1] = green;
    object->albedo[2] = blue;
}

void scene_set_light(Scene *scene, double x, double y, double z)
{
    Light *light = &scene->light;
    const double direction[3] = {x, y, z};
    const float radiance[3] = {0.92f, 0.88f, 0.80f};
    const float ambient[3] = {0.17f, 0.19f, 0.24f};
    dvec_copy(direction, light->direction);
    dvec_normalize(light->direction);
    memcpy(light->radiance, radiance, sizeof radiance);
    memcpy(light->ambient, ambient, sizeof ambient);
}

void scene_set_camera(Scene *scene, const double position[3],
                      const double target[3], double degrees)
{
    Camera *camera = &scene->camera;
    dvec_copy(position, camera->position);
    dvec_copy(target, camera->target);
    camera->up[1] = 1;
    camera->fov_y = RADIANS(degrees);
}

void scene_set_default_view(Scene *scene)
{
    const double eye[3] = {-0.55, 2.75, 4.6};
    const double target[3] = {0.12, 0.33, 0.05};
    scene_set_camera(scene, eye, target, 32);
    scene_set_light(scene, 0.66, -0.60, -0.14);
}
