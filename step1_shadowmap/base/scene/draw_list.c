#include "step1_shadowmap/base/scene/draw_list.h"

#include "step1_shadowmap/base/scene/dvec.h" // dvec_dot

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

void draw_list_nearest_first(DrawList *list, const Scene *scene)
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

void draw_list_all(DrawList *list, const Scene *scene)
{
    list->count = scene->object_count;
    for (int i = 0; i < scene->object_count; i++) {
        list->objects[i] = i;
    }
}
