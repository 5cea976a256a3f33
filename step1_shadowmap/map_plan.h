// What of the map is drawn, and when again: decided from the facts.
#ifndef STEP1_MAP_PLAN_H
#define STEP1_MAP_PLAN_H

#include <stdint.h> // uint64_t

#include "step1_shadowmap/base/leave_out/facts.h" // Facts
#include "step1_shadowmap/base/gl/gl.h"           // GLenum

typedef struct LayerPlan {
    Rect rect;      // the texels that are drawn; empty: the layer is left out
    DrawList list;  // the objects that are drawn into them
    int behind;     // objects that are left out, see facts_list_casters
    bool draw;      // in this frame, see map_plan_begin
    Rect looked_up; // by receivers
    // What the texels are made from (see stamp_layer()); and this and that when
    // they were last drawn, 0 if never. What is filtered of them grows with
    // what is looked up, so it is as new as they are.
    uint64_t stamp, drawn_stamp;
    Rect drawn_for;
} LayerPlan;

typedef struct MapPlan {
    const Scene *scene;
    const Views *views;
    LayerPlan layers[VIEW_MAX_LAYERS];
    int layer_count;
    bool lookups; // some layer is looked up
    bool always;  // drawn in every frame, although nothing has changed
} MapPlan;

// Decides for each layer, and adds its rows to the facts' plan. `pass` is the
// pass's name, `needed` what the later passes read of each layer, `format` that
// of a texel. All zero before the first time; what was drawn is remembered from
// one call to the next.
void map_plan_decide(MapPlan *plan, Facts *facts, const Rect needed[],
                     const char *pass, GLenum format);

// The same for lookups that read so many texels to each side of the receiver.
void map_plan_decide_within(MapPlan *plan, Facts *facts, int reach,
                            const char *pass, GLenum format);

// A frame begins: which layers are drawn in it? Those that have changed since
// they were, which they are from here on. False where nothing is looked up.
bool map_plan_begin(MapPlan *plan);

// How many texels are drawn in this frame; and how many a later pass writes,
// which has a rectangle of its own in each of these layers.
size_t map_plan_texels(const MapPlan *plan);
size_t map_plan_texels_of(const MapPlan *plan, const Rect rects[]);

// Every layer is drawn again, for the shaders have changed.
void map_plan_forget(MapPlan *plan);

// Every object in every texel of every layer, for the files of --dump.
MapPlan map_plan_whole(const MapPlan *plan);

#endif
