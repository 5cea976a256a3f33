// Which objects are drawn: into the picture, and into a part of a map.
#ifndef BASE_CASTERS_H
#define BASE_CASTERS_H

#include "step1_shadowmap/base/light/view.h" // Views

static inline bool rect_is_empty(const Rect *rect)
{
    return rect->low[0] >= rect->high[0] || rect->low[1] >= rect->high[1];
}

// The objects that may be in the picture, or all, the nearest first.
void casters_in_picture(DrawList *list, const Views *views, const Scene *scene,
                        bool all);

// Every object whose outline in the map may cover one of these texels, but
// those behind t = `deepest` for certain. Returns how many these are.
int casters_list(DrawList *list, const Views *views, const Scene *scene,
                 int layer, const Rect *texels, double deepest);

#endif
