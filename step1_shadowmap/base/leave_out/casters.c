#include "step1_shadowmap/base/leave_out/casters.h"

#include <math.h> // fmin, sqrt, INFINITY

#include "step1_shadowmap/base/leave_out/volume.h" // volume_of_texels
#include "step1_shadowmap/base/scene/dvec.h"       // dvec_dot, dvec_subtract

// What is outside by nothing at all is half a pixel from the next pixel's
// middle, and a rasteriser moves corners by far less.
static bool misses_picture(const Views *views, const Object *object)
{
    Volume picture = volume_of_picture(views);
    double corners[8][3];
    object_box(object, views->origin, corners);
    return volume_misses(&picture, corners);
}

static double square_distance(const Scene *scene, int object)
{
    double apart[3];
    for (int i = 0; i < 3; i++) {
        apart[i] =
            scene->objects[object].transform[i][3] - scene->camera.position[i];
    }
    return dvec_dot(apart, apart);
}

// Puts the object before all that are further away.
static void add_by_distance(DrawList *list, const Scene *scene, int object)
{
    double distance = square_distance(scene, object);
    int place = list->count++;
    for (; place > 0; place--) {
        int before = list->objects[place - 1];
        if (square_distance(scene, before) <= distance) {
            break;
        }
        list->objects[place] = before;
    }
    list->objects[place] = object;
}

// What is drawn later and lies behind need not be shaded. So the objects come
// by the distance of their origins from the camera, and last the ground, which
// casts nothing and on which all of them stand.
static void nearest_first(DrawList *list, const Scene *scene)
{
    list->count = 0;
    for (int i = 0; i < scene->object_count; i++) {
        if (scene->objects[i].casts) {
            add_by_distance(list, scene, i);
        }
    }
    for (int i = 0; i < scene->object_count; i++) {
        if (!scene->objects[i].casts) {
            list->objects[list->count++] = i;
        }
    }
}

void casters_in_picture(DrawList *list, const Views *views, const Scene *scene,
                        bool all)
{
    int kept = 0;
    nearest_first(list, scene);
    for (int i = 0; i < list->count; i++) {
        int object = list->objects[i];
        if (all || !misses_picture(views, &scene->objects[object])) {
            list->objects[kept++] = object;
        }
    }
    list->count = kept;
}

// The least t of what is in a box, or somewhat less.
static double nearest(const Views *views, int layer, double corners[8][3])
{
    double middle[3] = {0, 0, 0}, away[3], least = INFINITY;
    for (int i = 0; i < 8; i++) {
        least = fmin(least, view_light_depth(views, layer, corners[i]));
        for (int k = 0; k < 3; k++) {
            middle[k] += corners[i][k] / 8;
        }
    }
    if (views->light_position[3] == 0) {
        return least;
    }
    // A distance may be least between the corners.
    dvec_subtract(corners[0], middle, away);
    return view_light_depth(views, layer, middle) -
           view_light_steepest(views, layer) * sqrt(dvec_dot(away, away));
}

// Of t, in a map and in the picture.
#define ROUNDING 1e-5

static Volume volume_of(const Views *views, int layer, const Rect *texels)
{
    const int size[2] = {views->width, views->height};
    double low[2], high[2];
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = (texels->low[axis] - 1.0) / size[axis];
        high[axis] = (texels->high[axis] + 1.0) / size[axis];
    }
    return volume_of_texels(views, layer, low, high);
}

int casters_list(DrawList *list, const Views *views, const Scene *scene,
                 int layer, const Rect *texels, double deepest)
{
    Volume volume = volume_of(views, layer, texels);
    int behind = 0;
    list->count = 0;
    for (int i = 0; i < scene->object_count && !rect_is_empty(texels); i++) {
        double corners[8][3];
        object_box(&scene->objects[i], views->origin, corners);
        if (volume_misses(&volume, corners)) {
            continue;
        }
        if (deepest < INFINITY &&
            nearest(views, layer, corners) > deepest + ROUNDING) {
            behind++;
        } else {
            list->objects[list->count++] = i;
        }
    }
    return behind;
}
