#include "step1_shadowmap/base/draw_list.h"

void draw_list_all(DrawList *list, const Scene *scene)
{
    list->count = scene->object_count;
    for (int i = 0; i < scene->object_count; i++) {
        list->objects[i] = i;
    }
}
