// Spot and point lights in a scene.
#include <string.h> // strcmp

#include "step1_shadowmap/base/scene/dvec.h"        // dvec_copy, dvec_subtract
#include "step1_shadowmap/base/scene/scene_build.h" // scene_change_light
#include "step1_shadowmap/base/scenes/build.h"      // scene_set_local_light
#include "step1_shadowmap/base/system/die.h"        // die_usage

static const char *const kind_names[] = {[LIGHT_DIRECTIONAL] = "directional",
                                         [LIGHT_SPOT] = "spot",
                                         [LIGHT_POINT] = "point"};

const char *light_kind_name(LightKind kind)
{
    return kind_names[kind];
}

static LightKind find_kind(const char *name)
{
    for (int kind = LIGHT_DIRECTIONAL; kind <= LIGHT_POINT; kind++) {
        if (strcmp(kind_names[kind], name) == 0) {
            return (LightKind)kind;
        }
    }
    die_usage("--light '%s': allowed are directional, spot, point", name);
}

static double distance_between(const double a[3], const double b[3])
{
    double offset[3];
    dvec_subtract(a, b, offset);
    return sqrt(dvec_dot(offset, offset));
}

// A light that has a direction gets the place that the other kinds need:
// `distance` before what the camera looks at.
static void place_light(Scene *scene, double distance)
{
    Light *light = &scene->light;
    for (int k = 0; k < 3; k++) {
        light->position[k] =
            scene->camera.target[k] - distance * light->direction[k];
    }
    light->reference = distance;
}

static void replace_light(Scene *scene, LightKind kind)
{
    Light *light = &scene->light;
    if (kind == light->kind) {
        return;
    }
    if (light->kind == LIGHT_DIRECTIONAL) {
        place_light(scene, distance_between(scene->camera.position,
                                            scene->camera.target));
    }
    light->kind = kind;
    light->cone = light->cone > 0 ? light->cone : RADIANS(32);
    light->near = light->far = 0; // of another measure of depth
}

void scene_change_light(Scene *scene, bool raised, const char *kind)
{
    if (raised && scene->light.kind != LIGHT_DIRECTIONAL) {
        place_light(scene, distance_between(scene->light.position,
                                            scene->camera.target));
    }
    if (kind != NULL) {
        replace_light(scene, find_kind(kind));
    }
}

void scene_set_local_light(Scene *scene, LightKind kind,
                           const double position[3], const double target[3],
                           double reference)
{
    double aim[3];
    dvec_subtract(target, position, aim);
    scene_set_light(scene, aim[0], aim[1], aim[2]);
    scene->light.kind = kind;
    dvec_copy(position, scene->light.position);
    scene->light.reference = reference;
}
