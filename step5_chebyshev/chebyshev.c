#include "step5_chebyshev/chebyshev.h"

#include <stdio.h> // snprintf

const Option chebyshev_options[] = {
    {"min-variance", OPTION_NUMBER, offsetof(ChebyshevSettings, min_variance),
     0, 1, "auto", "X",
     "least variance, in units of the squared depth range; auto: "
     "add what rounding can hide of it, from format and filter"},
    {"bleed-reduction", OPTION_NUMBER,
     offsetof(ChebyshevSettings, bleed_reduction), 0, 0.9999, NULL, "X",
     "visibility up to X becomes 0, the rest is stretched"},
    {0},
};

ChebyshevSettings chebyshev_settings(void)
{
    return (ChebyshevSettings){.min_variance = OPTION_AUTO};
}

// One rounding changes a number by at most u = 2^-24 of itself. A mean of n
// texels rounds each of them n times, and its weight once. After N roundings M1
// is off by N u M1. M2 - M1 * M1 is off by 3 N u M2, as M1 * M1 is at most M2,
// and by 3 u M2 more: two squares and the difference are rounded. Each axis of
// the lookup, a + w (b - a), is off by 3 u of the largest depth, 1.
GuardNumbers chebyshev_guard(int radius, int factor)
{
    int along = radius > 0 ? 2 * radius + 2 : 0; // one axis
    int group = factor > 1 ? factor * factor + 1 : 0;
    float u = 1.01F * 0x1p-24F; // a hundredth for the products of errors
    float part = u * (float)(2 * along + group + 1), rest = 6 * u;
    return (GuardNumbers){.mean = {part, rest},
                          .variance = {3 * part, 3 * rest}};
}

double chebyshev_spread(const ChebyshevSettings *settings, int radius,
                        int factor)
{
    double texels = radius * (radius + 1.0) / 3; // 2 radius + 1 equal weights
    return settings->min_variance == OPTION_AUTO ? texels * factor * factor : 0;
}

void chebyshev_constants(const ChebyshevSettings *settings, int radius,
                         int factor, char text[CHEBYSHEV_CONSTANTS_BYTES])
{
    bool automatic = settings->min_variance == OPTION_AUTO;
    GuardNumbers guard = {{0, 0}, {0, 0}};
    if (automatic) {
        guard = chebyshev_guard(radius, factor);
    }
    snprintf(text, CHEBYSHEV_CONSTANTS_BYTES,
             "const float min_variance = %.9g, bleed_reduction = %.9g;"
             "const vec2 guard_variance = vec2(%.9g, %.9g), "
             "guard_mean = vec2(%.9g, %.9g);",
             automatic ? 0 : settings->min_variance, settings->bleed_reduction,
             (double)guard.variance[0], (double)guard.variance[1],
             (double)guard.mean[0], (double)guard.mean[1]);
}
