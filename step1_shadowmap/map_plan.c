#include "step1_shadowmap/map_plan.h"

#include <stdio.h> // snprintf

#include "step1_shadowmap/base/leave_out/stamp.h" // stamp_add

// What a layer's texels are made from: the view, to the last bit, and the
// objects. The origin is the camera, so a camera that moves changes every map
// in its last bits: such a map is another one.
static uint64_t stamp_layer(const Facts *facts, int layer, const DrawList *list)
{
    const Views *views = facts->views;
    const LightView *view = &views->light[layer];
    uint64_t stamp = STAMP_START;
    stamp_add(&stamp, views->origin, sizeof views->origin);
    stamp_add(&stamp, views->light_position, sizeof views->light_position);
    stamp_add(&stamp, &views->depth_per_distance,
              sizeof views->depth_per_distance);
    stamp_add(&stamp, view->map_from_relative, sizeof view->map_from_relative);
    stamp_add(&stamp, view->depth_from_relative,
              sizeof view->depth_from_relative);
    for (int i = 0; i < list->count; i++) {
        const Object *object = &facts->scene->objects[list->objects[i]];
        stamp_add(&stamp, &object->mesh, sizeof object->mesh);
        stamp_add(&stamp, object->transform, sizeof object->transform);
    }
    return stamp;
}

static void add_row(const LayerPlan *layer, int number, Facts *facts,
                    const char *pass, size_t texel_bytes)
{
    const int *size = facts->size;
    size_t all = (size_t)size[0] * (size_t)size[1];
    size_t saved = all - rect_texels(&layer->rect);
    char behind[48] = "";
    if (layer->behind > 0) {
        snprintf(behind, sizeof behind, "; %d behind all receivers",
                 layer->behind);
    }
    if (rect_is_empty(&layer->rect)) {
        plan_add(&facts->plan, pass, number, false, saved, texel_bytes,
                 "nothing looks it up");
    } else {
        plan_add(&facts->plan, pass, number, true, saved, texel_bytes,
                 "%dx%d of %dx%d texels are read; %d of %d objects%s",
                 layer->rect.high[0] - layer->rect.low[0],
                 layer->rect.high[1] - layer->rect.low[1], size[0], size[1],
                 layer->list.count, facts->scene->object_count, behind);
    }
}

void map_plan_decide(MapPlan *plan, Facts *facts, const Rect needed[],
                     const char *pass, GLenum format)
{
    plan->scene = facts->scene;
    plan->views = facts->views;
    plan->layer_count = facts->layer_count;
    plan->lookups = facts->lookups;
    plan->always = facts->redraw;
    for (int i = 0; i < facts->layer_count; i++) {
        LayerPlan *layer = &plan->layers[i];
        layer->rect = needed[i];
        layer->looked_up = facts_looked_up(facts, i);
        layer->behind =
            facts_list_casters(&layer->list, facts, i, &layer->rect);
        layer->stamp = stamp_layer(facts, i, &layer->list);
        add_row(layer, i, facts, pass, gl_texel_bytes(format));
    }
    bool again = plan->lookups && plan->always;
    plan_add(&facts->plan, "maps in later frames", -1, again, 0, 0, "%s",
             !plan->lookups ? "there are none"
             : again        ? "--redraw or --keep-all"
                     : "only where light, casters or views have changed");
}

void map_plan_decide_within(MapPlan *plan, Facts *facts, int reach,
                            const char *pass, GLenum format)
{
    Rect needed[VIEW_MAX_LAYERS];
    for (int i = 0; i < facts->layer_count; i++) {
        Rect looked_up = facts_looked_up(facts, i);
        needed[i] = rect_grow(&looked_up, reach, reach, facts->size);
    }
    map_plan_decide(plan, facts, needed, pass, format);
}

bool map_plan_begin(MapPlan *plan)
{
    for (int i = 0; i < plan->layer_count; i++) {
        LayerPlan *layer = &plan->layers[i];
        bool changed = layer->stamp != layer->drawn_stamp ||
                       !rect_holds(&layer->drawn_for, &layer->looked_up);
        layer->draw = !rect_is_empty(&layer->rect) && (plan->always || changed);
        if (layer->draw) {
            layer->drawn_stamp = layer->stamp;
            layer->drawn_for = layer->looked_up;
        }
    }
    return plan->lookups;
}

size_t map_plan_texels(const MapPlan *plan)
{
    Rect rects[VIEW_MAX_LAYERS];
    for (int i = 0; i < plan->layer_count; i++) {
        rects[i] = plan->layers[i].rect;
    }
    return map_plan_texels_of(plan, rects);
}

size_t map_plan_texels_of(const MapPlan *plan, const Rect rects[])
{
    size_t texels = 0;
    for (int i = 0; i < plan->layer_count; i++) {
        texels += plan->layers[i].draw ? rect_texels(&rects[i]) : 0;
    }
    return texels;
}

void map_plan_forget(MapPlan *plan)
{
    for (int i = 0; i < plan->layer_count; i++) {
        plan->layers[i].drawn_stamp = 0;
    }
}

MapPlan map_plan_whole(const MapPlan *plan)
{
    MapPlan whole = *plan;
    for (int i = 0; i < whole.layer_count; i++) {
        LayerPlan *layer = &whole.layers[i];
        layer->rect = rect_whole(plan->views->width, plan->views->height);
        layer->list = plan->views->light[i].seen;
        layer->draw = true;
    }
    return whole;
}
