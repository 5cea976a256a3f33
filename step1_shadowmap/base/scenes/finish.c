// What is known of a scene once all of it is in its place.
#include <math.h> // fmax, fmin, isfinite, INFINITY

#include "step1_shadowmap/base/scene/dvec.h"        // dvec_dot, dvec_subtract
#include "step1_shadowmap/base/scene/scene_build.h" // scene_finish
#include "step1_shadowmap/base/system/die.h"        // die

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

void scene_finish(Scene *scene)
{
    for (int i = 0; i < scene->object_count; i++) {
        check_object(scene, &scene->objects[i]);
    }
    if (scene->camera.reach == 0) {
        scene->camera.reach = 1.1 * distance_to_all(scene);
    }
}
