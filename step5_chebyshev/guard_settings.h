// Step 5: what of guard.h there is to guard.
#ifndef STEP5_GUARD_SETTINGS_H
#define STEP5_GUARD_SETTINGS_H

#include "step3_moments/moments.h" // MomentsSettings
#include "step4_blur/blur.h"       // Blur
#include "step5_chebyshev/guard.h" // GuardNumbers

// Against the averages between the depths in the map and the bound, the last of
// which is of so many lookups; 1: there is none.
GuardNumbers guard_of_settings(const MomentsSettings *moments,
                               const BlurSettings *settings, const Blur *filter,
                               int lookups);

#endif
