// What the picture needs of the light's maps: facts about the scene and the
// views, found before anything is drawn, on which the stages decide what they
// leave out. Conservative: what may be needed is. Nothing here knows a stage.
#ifndef BASE_FACTS_H
#define BASE_FACTS_H

#include <stdbool.h>
#include <stdint.h> // uint64_t

#include "step1_shadowmap/base/leave_out/plan.h"      // Plan
#include "step1_shadowmap/base/leave_out/receivers.h" // LayerFacts
#include "step1_shadowmap/base/run/settings.h"        // BaseSettings

typedef struct Facts {
    const Scene *scene;
    uint64_t stamp; // of what may change in it
    const Views *views;
    const BaseSettings *settings;
    LayerFacts layers[VIEW_MAX_LAYERS];
    int layer_count;
    int size[2];   // of the map, texels
    bool lookups;  // some layer has receivers
    bool later;    // it may have them in a later frame, when all may move
    bool dumped;   // whole maps are wanted, looked up or not
    bool redraw;   // the maps are wanted anew in every frame
    bool compared; // each depth by itself: what is behind all receivers is as
                   // good as nothing
    bool whole;    // nothing is to be left out: every layer is looked up
                   // everywhere
    Plan plan;     // what has been decided from the facts
} Facts;

// Fits the views with room for so many texels (views_fit) and finds the facts.
// Does nothing, and returns false, if since the last time neither the camera
// nor an object has moved. The scene, the views and the settings have to stay
// where they are. With --keep-all, or a choice of --show that looks the map up
// everywhere, the facts are those of a scene that needs everything.
bool facts_collect(Facts *facts, const Scene *scene, Views *views,
                   const BaseSettings *settings, int reach);

// Whether the picture's shader has to look maps up, and whether there have to
// be any.
bool facts_look_up(const Facts *facts);
bool facts_make_maps(const Facts *facts);

// Every receiver is lit for certain: nothing is looked up. `why` is for --plan.
void facts_drop_lookups(Facts *facts, const char *why);

// The texels that receivers lie in; none where nothing is looked up.
Rect facts_looked_up(const Facts *facts, int layer);

// A lookup may be anywhere in the layers that receivers are in.
void facts_look_everywhere(Facts *facts);

// The objects on the layer's list whose outline in the map may cover one of
// these texels. Returns how many more would, but are behind all receivers.
int facts_list_casters(DrawList *list, const Facts *facts, int layer,
                       const Rect *texels);

#endif
