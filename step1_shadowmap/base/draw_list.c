#include "step1_shadowmap/base/draw_list.h"

static void add_objects(DrawList *list, const Scene *scene, bool casts)
{
    for (int i = 0; i < scene->object_count; i++) {
        if (scene->objects[i].casts == casts) {
            list->objects[list->count++] = i;
        }
    }
}

void draw_list_ground_last(DrawList *list, const Scene *scene)
{
    list->count = 0;
    add_objects(list, scene, true);
    add_objects(list, scene, false);
}

void draw_list_all(DrawList *list, const Scene *scene)
{
    list->count = scene->object_count;
    for (int i = 0; i < scene->object_count; i++) {
        list->objects[i] = i;
    }
}
