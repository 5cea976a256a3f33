#include "tests/oracle/filters/chebyshev_bound.h"

#include <algorithm> // clamp, max, min
#include <cmath>     // exp2, floor, log2, pow, sqrt

#include "tests/oracle/filters/footprint.h" // blur_filters
#include "tests/oracle/lib/rounding.h"

double depth_noise(const MapView &view, const glm::dvec3 &position)
{
    glm::dvec3 gradient(view.rows[2]);
    if (view.projected) {
        glm::dvec4 p(position, 1);
        double w = glm::dot(view.rows[3], p);
        double t = glm::dot(view.rows[2], p) / w;
        gradient = (gradient - t * glm::dvec3(view.rows[3])) / w;
    }
    double steepness = glm::length(gradient);
    if (!view.parallel() && !view.projected)
        steepness = 1 / (view.far - view.near);
    return 64 * UNIT_ROUNDOFF * steepness * glm::length(position);
}

namespace
{

// What goes into the bound: the variance, and how much is added to the mean.
struct Guarded {
    Interval more, variance;
};

} // namespace

static Interval variance_of(const Moments &m, const Settings &settings)
{
    if (settings.central)
        return m.second;
    Interval squared = rounded(square(m.m1), UNIT_ROUNDOFF);
    return rounded(m.second - squared, UNIT_ROUNDOFF);
}

// --min-variance auto of M1 and M2: sums of positive numbers.
static Guarded guarded_raw(const Moments &m, Interval variance,
                           const Formula &f)
{
    Interval more_mean = f.guard.mean * m.m1 + Interval(f.guard.mean_fixed);
    Interval more = f.guard.variance * m.second + f.guard.variance_fixed;
    return {rounded(more_mean, rounding_share(3)),
            rounded(maximum(variance, 0) + more, rounding_share(4))};
}

static Interval root(Interval a)
{
    return {std::sqrt(std::max(a.lo, 0.0)), std::sqrt(std::max(a.hi, 0.0))};
}

// Of mean and variance: also. A root or a length of a vector may be 3 units
// off, and the noise is made of four of those.
static Guarded guarded_central(const Moments &m, Interval variance,
                               double noise, const Formula &f)
{
    variance = maximum(variance, 0);
    Interval size = root(square(m.m1) + variance);
    size = {rounded_part(size.lo), rounded_part(size.hi)};
    Interval part = {rounded_part(m.m1.lo), rounded_part(m.m1.hi)};
    Interval deviation = root(variance + Interval(f.guard.variance_fixed));
    Interval spread = f.guard.spread * deviation;
    Interval more_mean =
        f.guard.mean * part + spread + Interval(f.guard.mean_fixed);
    Interval most = deviation + spread + f.guard.variance * size +
                    Interval(f.guard.mean_fixed);
    Interval own = rounded(square(noise), rounding_share(32));
    return {rounded(more_mean, rounding_share(12)),
            rounded(square(most) + own, rounding_share(20))};
}

static Guarded guarded(const Moments &m, Interval variance, double noise,
                       const Formula &f)
{
    if (f.settings.auto_variance)
        return f.settings.central ? guarded_central(m, variance, noise, f)
                                  : guarded_raw(m, variance, f);
    Interval least = rounded(f.settings.min_variance, UNIT_ROUNDOFF);
    return {0, maximum(variance, least)};
}

static Interval biased(Interval variance, const Settings &settings)
{
    if (settings.variance_bias == 0)
        return variance;
    Interval bias = rounded(settings.variance_bias, UNIT_ROUNDOFF);
    Interval sum = rounded(variance + bias, UNIT_ROUNDOFF);
    return {std::min(sum.lo, 1.0), std::min(sum.hi, 1.0)};
}

static Interval p_max(Interval above, Interval v)
{
    if (above.hi <= 0)
        return 1;
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

Interval reduced(Interval p, const Settings &settings)
{
    double a = settings.bleed_reduction;
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

// The mean is added to once, and taken from t once.
Bound bound_of(const Moments &moments, Interval before, Interval variance,
               double noise, const Formula &formula)
{
    Guarded guard = guarded(moments, variance, noise, formula);
    Interval v = biased(guard.variance, formula.settings);
    Interval left = rounded(before - guard.more, UNIT_ROUNDOFF);
    if (formula.settings.auto_variance)
        left = widened(left, UNIT_ROUNDOFF * magnitude(moments.m1).hi);
    return {left, p_max(left, v)};
}

Interval chebyshev(const Moments &moments, Interval t, double noise,
                   const Formula &formula)
{
    Interval variance = variance_of(moments, formula.settings);
    Bound bound = bound_of(moments, t - moments.m1, variance, noise, formula);
    return reduced(bound.p, formula.settings);
}

double chebyshev_exact(double m1, double variance, double t, double noise,
                       const Formula &formula)
{
    const Settings &settings = formula.settings;
    Moments moments{m1, settings.central ? variance : variance + m1 * m1};
    Guarded guard = guarded(moments, variance, noise, formula);
    double mean = m1 + (guard.more.lo + guard.more.hi) / 2;
    double v = (guard.variance.lo + guard.variance.hi) / 2;
    if (t <= mean)
        return 1;
    v = std::min(v + settings.variance_bias, 1.0);
    double p = v / (v + (t - mean) * (t - mean));
    double a = settings.bleed_reduction;
    double s = std::clamp((p - a) / (1 - a), 0.0, 1.0);
    return settings.smooth ? smooth_step(s) : s;
}

// How often the filter stores: the downsampled map, and each filter per axis.
static int blur_stores(const Settings &settings)
{
    return (settings.downsample > 1 ? 1 : 0) +
           2 * int(blur_filters(settings).size());
}

double blur_share(const Settings &settings)
{
    int f = settings.downsample;
    int operations = f > 1 ? f * f + 1 : 0;
    for (const AxisFilter &filter : blur_filters(settings))
        operations += 2 * (int(filter.weights.size()) + 1);
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
    return settings.half ? (settings.central ? 0x1p-11 : 0x1p-10) : 0;
}

double store_absolute(const Settings &settings)
{
    return settings.half ? (settings.central ? 0x1p-25 : 0x1p-24) : 0;
}
