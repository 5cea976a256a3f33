// Which texels each pass of the filter has to write, decided from what the
// picture looks up: from the last pass back to the first, each wider by what
// the one after it reads around them.
#ifndef STEP4_BLUR_PLAN_H
#define STEP4_BLUR_PLAN_H

#include "step1_shadowmap/map_plan.h" // Facts, Rect
#include "step4_blur/blur.h"          // BlurSettings

// By layer, in texels of the pass's own target; empty where a layer is not
// filtered.
typedef struct BlurPlan {
    Rect moments[VIEW_MAX_LAYERS]; // what is read of the map of moments
    BlurRects write;
} BlurPlan;

// Adds the filter's rows to the facts' plan; `texel_bytes` is the size of a
// texel of moments.
void blur_plan_decide(BlurPlan *plan, const BlurSettings *settings,
                      Facts *facts, size_t texel_bytes);

#endif
