// The techniques of step 2, after those of step 1.
#include "step1_shadowmap/base/seams/technique.h"

extern const Technique map_footprint, map_lights, map_splits, pcf_adaptive,
    pcf_poisson, pcf_bilinear;

const Technique *const techniques[] = {
    &map_footprint, &map_lights,   &map_splits, &pcf_adaptive,
    &pcf_poisson,   &pcf_bilinear, NULL};
