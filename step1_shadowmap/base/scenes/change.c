// What can be asked of every scene, and what is known of it in the end.
#include <math.h> // cos, fmax, fmin, hypot, isfinite, sin, INFINITY

#include "step1_shadowmap/base/scene/dvec.h"   // dvec_dot, dvec_normalize, ...
#include "step1_shadowmap/base/scenes/build.h" // scene_change_light
#include "step1_shadowmap/base/system/die.h"   // die

// The keys of every scene. An elevation of 0 keeps the scene's own light.
enum { KEY_OFFSET, KEY_SCALE, KEY_ELEVATION };
const SceneKey more_keys[SCENE_MAX_KEYS] = {
    {"offset", -1e8, 1e8, 0, "moves the world along x, y and z, world units"},
    {"scale", 1e-6, 1e6, 1, "scales the world about its origin"},
    {"elevation", 0, 90, 0,
     "of the light above the horizon, degrees; 0: the scene's own"},
};

static double distance_between(const double a[3], const double b[3])
{
    double offset[3];
    dvec_subtract(a, b, offset);
    return sqrt(dvec_dot(offset, offset));
}

// Widens a box by an object, in world space.
static void include_object(const Object *object, double low[3], double high[3])
{
    for (size_t i = 0; i < object->mesh->vertex_count; i++) {
        const float *p = object->mesh->vertices[i].position;
        for (int row = 0; row < 3; row++) {
            const double *m = object->transform[row];
            double x = m[0] * (double)p[0] + m[1] * (double)p[1] +
                       m[2] * (double)p[2] + m[3];
            low[row] = fmin(low[row], x);
            high[row] = fmax(high[row], x);
        }
    }
}

// How far the camera is from the far end of the box of the casters, or of
// everything if nothing casts: there all shadows are within reach.
static double distance_to_all(const Scene *scene)
{
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double middle[3];
    bool any = false;
    for (int i = 0; i < scene->object_count; i++) {
        any = any || scene->objects[i].casts;
    }
    for (int i = 0; i < scene->object_count; i++) {
        if (scene->objects[i].casts || !any) {
            include_object(&scene->objects[i], low, high);
        }
    }
    for (int k = 0; k < 3; k++) {
        middle[k] = 0.5 * (low[k] + high[k]);
    }
    return distance_between(scene->camera.position, middle) +
           0.5 * distance_between(low, high);
}

// One vertex that is no number would spread over all that is fitted to it.
static void check_object(const Scene *scene, const Object *object)
{
    for (size_t i = 0; i < object->mesh->vertex_count; i++) {
        const MeshVertex *vertex = &object->mesh->vertices[i];
        for (int k = 0; k < 3; k++) {
            if (!isfinite(vertex->position[k]) ||
                !isfinite(vertex->normal[k])) {
                die("scene %s: object '%s': vertex %zu is not finite: mend its "
                    "mesh, or leave it out",
                    scene->name, object->name, i);
            }
        }
    }
}

static void finish(Scene *scene)
{
    for (int i = 0; i < scene->object_count; i++) {
        check_object(scene, &scene->objects[i]);
    }
    if (scene->camera.reach == 0) {
        scene->camera.reach = 1.1 * distance_to_all(scene);
    }
}

static void raise_light(Light *light, double degrees)
{
    double x = light->direction[0];
    double z = light->direction[2];
    double length = hypot(x, z);
    // A light straight from above has no azimuth of its own: it gets +x.
    double azimuth[2] = {length > 0 ? x / length : 1,
                         length > 0 ? z / length : 0};
    light->direction[0] = cos(RADIANS(degrees)) * azimuth[0];
    light->direction[1] = -sin(RADIANS(degrees));
    light->direction[2] = cos(RADIANS(degrees)) * azimuth[1];
    dvec_normalize(light->direction);
}

static void move_point(double point[3], double scale, double offset)
{
    for (int k = 0; k < 3; k++) {
        point[k] = point[k] * scale + offset;
    }
}

static void move_world(Scene *scene, double scale, double offset)
{
    move_point(scene->camera.position, scale, offset);
    move_point(scene->camera.target, scale, offset);
    move_point(scene->light.anchor, scale, offset);
    move_point(scene->light.position, scale, offset);
    scene->light.reference *= scale;
    scene->camera.reach *= scale;
    scene->light.near *= scale;
    scene->light.far *= scale;
    for (int i = 0; i < scene->object_count; i++) {
        for (int row = 0; row < 3; row++) {
            double *m = scene->objects[i].transform[row];
            m[0] *= scale;
            m[1] *= scale;
            m[2] *= scale;
            m[3] = m[3] * scale + offset;
        }
    }
}

void scene_change(Scene *scene, const double values[], const char *kind)
{
    bool raised = values[KEY_ELEVATION] > 0;
    if (raised) {
        raise_light(&scene->light, values[KEY_ELEVATION]);
    }
    scene_change_light(scene, raised, kind);
    move_world(scene, values[KEY_SCALE], values[KEY_OFFSET]);
    finish(scene);
}
