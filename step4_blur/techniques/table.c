// The techniques of step 4, after those of steps 1 and 3.
#include "step1_shadowmap/base/seams/technique.h"

extern const Technique map_footprint, map_lights, map_splits, moments_half,
    moments_central, moments_projected, moments_msaa, moments_slope,
    blur_kernels, blur_central, blur_mips, blur_sat;

const Technique *const techniques[] = {&map_footprint,
                                       &map_lights,
                                       &map_splits,
                                       &moments_half,
                                       &moments_central,
                                       &moments_projected,
                                       &moments_msaa,
                                       &moments_slope,
                                       &blur_kernels,
                                       &blur_central,
                                       &blur_mips,
                                       &blur_sat,
                                       NULL};
