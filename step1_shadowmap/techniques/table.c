// The techniques of step 1.
#include "step1_shadowmap/base/seams/technique.h"

extern const Technique map_footprint, map_lights, map_splits;

const Technique *const techniques[] = {&map_footprint, &map_lights, &map_splits,
                                       NULL};
