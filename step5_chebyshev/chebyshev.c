#include "step5_chebyshev/chebyshev.h"

#include <stdio.h>  // snprintf
#include <string.h> // strcmp

const Option chebyshev_options[] = {
    {.name = "min-variance",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, min_variance),
     .minimum = 0,
     .maximum = 1,
     .choices = "auto",
     .argument = "X",
     .help = "least variance, in units of the squared depth range; auto: "
             "add what rounding can hide of it, from format and filter"},
    {.name = "variance-bias",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, variance_bias),
     .minimum = 0,
     .maximum = 1,
     .argument = "X",
     .help = "added to every variance, which is then at most 1"},
    {.name = "bleed-reduction",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, bleed_reduction),
     .minimum = 0,
     .maximum = 0.9999,
     .argument = "X",
     .help = "visibility up to X becomes 0, the rest is stretched"},
    {.name = "reduction",
     .kind = OPTION_CHOICE,
     .offset = offsetof(ChebyshevSettings, reduction),
     .choices = "linear,smooth",
     .help = "how what is above the bleed reduction is stretched"},
    {0},
};

ChebyshevSettings chebyshev_settings(void)
{
    return (ChebyshevSettings){.min_variance = OPTION_AUTO,
                               .bleed_reduction = 0.18,
                               .reduction = "linear"};
}

const char *chebyshev_reduction_shader(const ChebyshevSettings *settings)
{
    return strcmp(settings->reduction, "smooth") == 0
               ? "step5_chebyshev/shaders/reduction_smooth.glsl"
               : "step5_chebyshev/shaders/reduction_linear.glsl";
}

const char *chebyshev_guard_shader(const ChebyshevSettings *settings,
                                   const MomentsSettings *moments)
{
    if (settings->min_variance != OPTION_AUTO) {
        return "step5_chebyshev/shaders/guard_constant.glsl";
    }
    return moments_are_central(moments)
               ? "step5_chebyshev/shaders/guard_central.glsl"
               : "step5_chebyshev/shaders/guard_raw.glsl";
}

void chebyshev_constants(const ChebyshevSettings *settings,
                         const GuardNumbers *guard,
                         char text[CHEBYSHEV_CONSTANTS_BYTES])
{
    // No file uses all of them.
    snprintf(text, CHEBYSHEV_CONSTANTS_BYTES,
             "const float min_variance = %.9g, variance_bias = %.9g, "
             "bleed_reduction = %.9g, guard_spread = %.9g;"
             "const vec2 guard_variance = vec2(%.9g, %.9g), "
             "guard_mean = vec2(%.9g, %.9g);",
             settings->min_variance, settings->variance_bias,
             settings->bleed_reduction, (double)guard->spread,
             (double)guard->variance[0], (double)guard->variance[1],
             (double)guard->mean[0], (double)guard->mean[1]);
}
