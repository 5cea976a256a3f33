#include "step1_shadowmap/base/light/region.h"

#include <math.h> // fmax, fmin, sqrt, INFINITY
#include <stdbool.h>
#include <string.h> // memcpy

#include "step1_shadowmap/base/scene/dvec.h" // dvec_copy, dvec_dot

int polygon_clip(double polygon[][3], int count, const double normal[3],
                 double limit)
{
    double result[POLYGON_MAX_CORNERS][3];
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const double *a = polygon[i];
        const double *b = polygon[(i + 1) % count];
        double inside_a = limit - dvec_dot(normal, a);
        double inside_b = limit - dvec_dot(normal, b);
        if (inside_a >= 0) {
            dvec_copy(a, result[kept++]);
        }
        if ((inside_a >= 0) != (inside_b >= 0)) {
            double part = inside_a / (inside_a - inside_b);
            for (int k = 0; k < 3; k++) {
                result[kept][k] = a[k] + part * (b[k] - a[k]);
            }
            kept++;
        }
    }
    memcpy(polygon, result, sizeof result[0] * (size_t)kept);
    return kept;
}

void vertex_relative(const Object *object, const double origin[3],
                     size_t vertex, double position[3])
{
    const float *local = object->mesh->vertices[vertex].position;
    for (int row = 0; row < 3; row++) {
        const double *m = object->transform[row];
        position[row] = m[0] * (double)local[0] + m[1] * (double)local[1] +
                        m[2] * (double)local[2] + (m[3] - origin[row]);
    }
}

void frame_coordinates(double axes[3][3], const double position[3],
                       double result[3])
{
    for (int axis = 0; axis < 3; axis++) {
        result[axis] = dvec_dot(axes[axis], position);
    }
}

// Whether the range holds a point already, inside of the planes or not.
static bool is_held(const void *held, const double point[3])
{
    const Region *region = held;
    return point[2] >= region->low && point[2] <= region->high &&
           dvec_dot(point, point) <= region->farthest * region->farthest;
}

// Widens the region's range to the part of one triangle that is inside, in the
// coordinates of the axes.
static void include_triangle(Region *region, double axes[3][3],
                             const Object *object, const double origin[3],
                             const uint32_t corners[3])
{
    double polygon[POLYGON_MAX_CORNERS][3];
    for (int k = 0; k < 3; k++) {
        double relative[3];
        vertex_relative(object, origin, corners[k], relative);
        frame_coordinates(axes, relative, polygon[k]);
    }
    int count = 3;
    if (is_held(region, polygon[0]) && is_held(region, polygon[1]) &&
        is_held(region, polygon[2])) {
        return;
    }
    for (int i = 0; i < 4; i++) {
        count =
            polygon_clip(polygon, count, region->normals[i], region->limits[i]);
    }
    for (int k = 0; k < count; k++) {
        region->low = fmin(region->low, polygon[k][2]);
        region->high = fmax(region->high, polygon[k][2]);
        region->farthest =
            fmax(region->farthest, sqrt(dvec_dot(polygon[k], polygon[k])));
    }
}

void region_include_scene(Region *region, double axes[3][3], const Scene *scene,
                          const double origin[3])
{
    region->low = INFINITY;
    region->high = -INFINITY;
    region->farthest = 0;
    for (int i = 0; i < scene->object_count; i++) {
        const Object *object = &scene->objects[i];
        if (object_box_is != NULL &&
            object_box_is(object, origin, axes, is_held, region)) {
            continue;
        }
        for (size_t k = 0; k < object->mesh->index_count; k += 3) {
            include_triangle(region, axes, object, origin,
                             object->mesh->indices + k);
        }
    }
}
