// The techniques of step 3, after those of step 1.
#include "step1_shadowmap/base/seams/technique.h"

extern const Technique map_footprint, map_lights, map_splits, moments_half,
    moments_central, moments_projected, moments_msaa, moments_slope;

const Technique *const techniques[] = {
    &map_footprint, &map_lights,      &map_splits,
    &moments_half,  &moments_central, &moments_projected,
    &moments_msaa,  &moments_slope,   NULL};
