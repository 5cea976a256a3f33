#include "step1_shadowmap/base/leave_out/facts.h"

#include <math.h> // fmin, sqrt, INFINITY

#include "step1_shadowmap/base/scene/dvec.h"      // dvec_dot, dvec_subtract
#include "step1_shadowmap/base/leave_out/stamp.h" // stamp_add
#include "step1_shadowmap/base/light/volume.h"    // volume_of_texels

static void find_receivers(Facts *facts, const int picture[2])
{
    receivers_find(facts->layers, facts->scene, facts->views, picture);
    for (int layer = 0; layer < facts->layer_count; layer++) {
        facts->lookups =
            facts->lookups || !rect_is_empty(&facts->layers[layer].looked_up);
    }
}

bool facts_look_up(const Facts *facts)
{
    return facts->lookups || facts->later;
}

bool facts_make_maps(const Facts *facts)
{
    return facts_look_up(facts) || facts->dumped;
}

void facts_drop_lookups(Facts *facts, const char *why)
{
    facts->lookups = false;
    facts->plan.count--; // the row of the lookup, which is the last so far
    plan_add(&facts->plan, "lookup", -1, false, 0, 0, "%s", why);
}

Rect facts_looked_up(const Facts *facts, int layer)
{
    return facts->lookups ? facts->layers[layer].looked_up
                          : (Rect){{0, 0}, {0, 0}};
}

void facts_look_everywhere(Facts *facts)
{
    for (int layer = 0; layer < facts->layer_count; layer++) {
        Rect *looked_up = &facts->layers[layer].looked_up;
        if (!rect_is_empty(looked_up)) {
            *looked_up = rect_whole(facts->size[0], facts->size[1]);
        }
    }
}

static void keep_all(Facts *facts)
{
    facts->whole = true;
    facts->lookups = true;
    for (int layer = 0; layer < facts->layer_count; layer++) {
        facts->layers[layer] =
            (LayerFacts){rect_whole(facts->size[0], facts->size[1]), INFINITY};
    }
}

// Of a scene, what may change from frame to frame.
static uint64_t stamp_scene(const Scene *scene)
{
    uint64_t stamp = STAMP_START;
    stamp_add(&stamp, &scene->camera, sizeof scene->camera);
    for (int i = 0; i < scene->object_count; i++) {
        stamp_add(&stamp, scene->objects[i].transform,
                  sizeof scene->objects[i].transform);
    }
    return stamp;
}

bool facts_collect(Facts *facts, const Scene *scene, Views *views,
                   const BaseSettings *settings, int reach)
{
    uint64_t stamp = stamp_scene(scene);
    if (facts->scene == scene && facts->stamp == stamp) {
        return false;
    }
    bool shadows = base_shadows(settings);
    views_fit(views, scene, settings, reach);
    *facts = (Facts){.scene = scene,
                     .stamp = stamp,
                     .views = views,
                     .settings = settings,
                     .layer_count = views->layers,
                     .size = {views->width, views->height},
                     .later = shadows &&
                              (settings->window || settings->move != NULL),
                     .dumped = shadows && settings->dump != NULL,
                     .redraw = settings->keep_all || settings->redraw};
    const char *why = "--shadows off";
    if (shadows && settings->keep_all) {
        keep_all(facts);
        why = "--keep-all";
    } else if (shadows && base_show_mode(settings)->reads_map) {
        keep_all(facts);
        why = "--show looks up every pixel";
    } else if (shadows) {
        find_receivers(facts, settings->size);
        why = facts->lookups ? "visible surfaces that may face the light are "
                               "in the map"
                             : "no visible surface that may face the light is "
                               "in the map";
    }
    plan_add(&facts->plan, "picture", -1, true, 0, 0,
             "%d of %d objects may be in it", views->seen.count,
             scene->object_count);
    plan_add(&facts->plan, "lookup", -1, facts->lookups, 0, 0, "%s", why);
    return true;
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

static bool is_behind(const Facts *facts, int layer, double corners[8][3])
{
    return facts->compared && nearest(facts->views, layer, corners) >
                                  facts->layers[layer].deepest + ROUNDING;
}

int facts_list_casters(DrawList *list, const Facts *facts, int layer,
                       const Rect *texels)
{
    const Views *views = facts->views;
    const DrawList *seen = &views->light[layer].seen;
    double low[2], high[2];
    int behind = 0;
    list->count = 0;
    for (int axis = 0; axis < 2; axis++) {
        low[axis] = (texels->low[axis] - 1.0) / facts->size[axis];
        high[axis] = (texels->high[axis] + 1.0) / facts->size[axis];
    }
    Volume volume = volume_of_texels(views, layer, low, high);
    for (int i = 0; i < seen->count && !rect_is_empty(texels); i++) {
        double corners[8][3];
        volume_object_box(&facts->scene->objects[seen->objects[i]],
                          views->origin, corners);
        if (!facts->whole && volume_misses(&volume, corners)) {
            continue;
        }
        if (is_behind(facts, layer, corners)) {
            behind++;
        } else {
            list->objects[list->count++] = seen->objects[i];
        }
    }
    return behind;
}
