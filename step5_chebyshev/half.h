// Step 5, --format auto: whether 16 bits do.
#ifndef STEP5_HALF_H
#define STEP5_HALF_H

#include "step1_shadowmap/base/leave_out/facts.h" // Facts
#include "step5_chebyshev/shading.h"              // ShadingSettings

// Settles --format auto, where that is what the settings say: 16 bits if they
// move no visibility by 1/255. Adds the row with the reason to the facts' plan.
void half_choose(ShadingSettings *settings, Facts *facts);

#endif
