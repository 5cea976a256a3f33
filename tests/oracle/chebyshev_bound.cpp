#include "tests/oracle/chebyshev_bound.h"

#include <algorithm> // clamp, max, min
#include <cmath>     // exp2, floor, log2, pow

#include "tests/oracle/rounding.h"

// Of the format that the moments are stored in.
static double format_roundoff(const Settings &settings)
{
    return settings.half ? 0x1p-11 : UNIT_ROUNDOFF;
}

static Interval minimum_variance(Interval m2, const Settings &settings)
{
    if (settings.auto_variance) // a power of two times m2: exact in float
        return 4 * format_roundoff(settings) * m2;
    return rounded(settings.min_variance, UNIT_ROUNDOFF);
}

static Interval variance_of(Interval m1, Interval m2, const Settings &settings)
{
    Interval squared = rounded(square(m1), UNIT_ROUNDOFF);
    Interval difference = rounded(m2 - squared, UNIT_ROUNDOFF);
    Interval variance = maximum(difference, minimum_variance(m2, settings));
    if (settings.variance_bias == 0)
        return variance;
    Interval bias = rounded(settings.variance_bias, UNIT_ROUNDOFF);
    Interval sum = rounded(variance + bias, UNIT_ROUNDOFF);
    return {std::min(sum.lo, 1.0), std::min(sum.hi, 1.0)};
}

static Interval p_max(Interval m1, Interval m2, Interval t,
                      const Settings &settings)
{
    Interval above = rounded(t - m1, UNIT_ROUNDOFF);
    if (above.hi <= 0)
        return 1;
    Interval v = variance_of(m1, m2, settings);
    Interval d2 = square(maximum(above, 0));
    // p grows with v and falls with d, so its ends are at the ends. Where
    // t <= m1 is possible, d2.lo is 0 and p.hi is 1, as the formula wants.
    double lo = v.lo / (v.lo + d2.hi);
    double hi = d2.lo == 0 ? 1 : v.hi / (v.hi + d2.lo);
    // Square, sum, quotient; 4 for a quotient made of a reciprocal (GLSL
    // allows 2.5 units).
    return rounded({lo, hi}, rounding_share(8));
}

// Hermite's cubic, the formula of GLSL's smoothstep between 0 and 1.
static double smooth_step(double s)
{
    return s * s * (3 - 2 * s);
}

Interval chebyshev(Interval m1, Interval m2, Interval t,
                   const Settings &settings)
{
    double a = settings.bleed_reduction;
    Interval p = p_max(m1, m2, t, settings);
    if (a == 0 && !settings.smooth)
        return clamp(p, 0, 1);
    Interval above = widened(p - a, 2 * UNIT_ROUNDOFF); // p <= 1: absolute
    Interval s = clamp(rounded(above / (1 - a), rounding_share(6)), 0, 1);
    if (!settings.smooth)
        return s;
    // It grows with s; its terms are at most 3, in five operations.
    return clamp(
        widened({smooth_step(s.lo), smooth_step(s.hi)}, 3 * rounding_share(5)),
        0, 1);
}

double chebyshev_exact(double m1, double m2, double t, const Settings &settings)
{
    if (t <= m1)
        return 1;
    double floor = settings.auto_variance ? 4 * format_roundoff(settings) * m2
                                          : settings.min_variance;
    double variance = std::max(m2 - m1 * m1, floor);
    variance = std::min(variance + settings.variance_bias, 1.0);
    double p = variance / (variance + (t - m1) * (t - m1));
    double a = settings.bleed_reduction;
    double s = std::clamp((p - a) / (1 - a), 0.0, 1.0);
    return settings.smooth ? smooth_step(s) : s;
}

// How often the filter stores: the downsampled map, and one pass per axis.
static int blur_stores(const Settings &settings)
{
    return (settings.downsample > 1 ? 1 : 0) + (settings.radius > 0 ? 2 : 0);
}

double blur_share(const Settings &settings)
{
    int f = settings.downsample, n = 2 * settings.radius + 1;
    int operations = f > 1 ? f * f + 1 : 0;
    operations += n > 1 ? 2 * (n + 1) : 0;
    double stored = std::pow(1 + store_share(settings), blur_stores(settings));
    return (1 + rounding_share(operations)) * stored - 1;
}

double blur_absolute(const Settings &settings)
{
    return blur_stores(settings) * store_absolute(settings) +
           table_absolute(settings);
}

double table_absolute(const Settings &settings)
{
    if (!settings.sat)
        return 0;
    double n = 2 * settings.radius + 1;
    double steps = std::exp2(std::floor(std::log2(0xffffffffu / (n * n))));
    return 0.5 / steps + rounding_share(16);
}

double resolve_share(const Settings &settings)
{
    if (settings.msaa == 1)
        return 0;
    return (1 + rounding_share(settings.msaa)) * (1 + store_share(settings)) -
           1;
}

double resolve_absolute(const Settings &settings)
{
    return settings.msaa == 1 ? 0 : store_absolute(settings);
}

double store_share(const Settings &settings)
{
    return settings.half ? 0x1p-10 : 0;
}

double store_absolute(const Settings &settings)
{
    return settings.half ? 0x1p-24 : 0;
}
