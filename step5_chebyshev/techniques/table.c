// The techniques of step 5, after those of steps 1, 3 and 4.
#include "step1_shadowmap/base/seams/technique.h"

extern const Technique map_footprint, map_lights, map_splits, moments_half,
    moments_central, moments_projected, moments_msaa, moments_slope,
    blur_kernels, blur_central, blur_mips, blur_sat, chebyshev_guarded,
    chebyshev_variance_bias, chebyshev_smooth, chebyshev_sat_width,
    chebyshev_soft, chebyshev_deferred;

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
                                       &chebyshev_guarded,
                                       &chebyshev_variance_bias,
                                       &chebyshev_smooth,
                                       &chebyshev_sat_width,
                                       &chebyshev_soft,
                                       &chebyshev_deferred,
                                       NULL};
