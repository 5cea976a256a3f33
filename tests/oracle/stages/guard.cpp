#include "tests/oracle/stages/guard.h"

#include <algorithm> // min
#include <cmath>     // exp2, pow, sqrt

#include "tests/oracle/filters/chebyshev_bound.h" // store_share
#include "tests/oracle/filters/footprint.h"       // blur_weights
#include "tests/oracle/filters/poisson_disc.h"    // POISSON_TAPS
#include "tests/oracle/lib/rounding.h"

static constexpr double UNDERFLOW = 0x1p-126;
// From here on the second order counts.
static constexpr double WIDEST_SPREAD = 1.0 / 8;

std::vector<MergePass> filter_passes(const Settings &settings)
{
    std::vector<MergePass> passes;
    double group = settings.downsample * settings.downsample;
    if (group > 1) // the sum is divided
        passes.push_back({group + 1, 1 / group, 0, true, false});
    for (int axis = 0; axis < 2 && !settings.sat; axis++)
        for (const AxisFilter &filter : blur_filters(settings)) {
            const std::vector<double> &weights = filter.weights;
            passes.push_back({double(weights.size()),
                              weights[weights.size() / 2], UNIT_ROUNDOFF, true,
                              false});
        }
    return passes;
}

static std::vector<MergePass> all_passes(const Run &run)
{
    const Settings &settings = run.settings;
    std::vector<MergePass> passes = filter_passes(settings);
    double samples = settings.msaa;
    if (samples > 1)
        passes.insert(passes.begin(),
                      {samples + 1, 1 / samples, 0, true, false});
    if (settings.sat)
        return passes;
    if (settings.mips) {
        int width = run.views.at(0).width / settings.downsample;
        int height = run.views.at(0).height / settings.downsample;
        for (; width % 2 == 0 && height % 2 == 0; width /= 2, height /= 2)
            passes.push_back({16, 9.0 / 64, 0, true, false});
    }
    passes.insert(passes.end(), settings.mips ? 3 : 2, {0, 0, 0, false, true});
    if (settings.mips && settings.anisotropy > 1)
        passes.push_back({settings.anisotropy + 1.0, 1.0 / settings.anisotropy,
                          0, false, false});
    if (settings.soft)
        passes.push_back(
            {POISSON_TAPS + 1.0, 1.0 / POISSON_TAPS, 0, false, false});
    return passes;
}

static double spread_of(const MergePass &pass, double store)
{
    double u = UNIT_ROUNDOFF, s = pass.stored ? store : 0;
    if (pass.two)
        return 7 * u + s;
    double r = ((3 * pass.taps + 12) * u + 3 * pass.defect) / pass.heaviest + s;
    return r / 2 +
           ((pass.taps + 3) * u + pass.defect) / std::sqrt(pass.heaviest);
}

CentralErrors central_errors(const std::vector<MergePass> &passes,
                             const Settings &settings)
{
    double store = store_share(settings);
    CentralErrors e;
    e.tiny = UNDERFLOW;
    for (const MergePass &pass : passes) {
        e.moved = e.mean;
        e.mean += UNIT_ROUNDOFF + (pass.stored ? store : 0);
        e.spread += spread_of(pass, store);
        e.tiny += 4 * (2 + pass.taps) * UNDERFLOW +
                  (pass.stored ? store_absolute(settings) : 0);
    }
    // Second order: products of these.
    double products = 1 + 8 * (std::min(e.spread, WIDEST_SPREAD) + e.mean);
    e.spread *= products;
    e.mean *= products;
    e.moved *= products;
    return e;
}

double rounded_part(double m)
{
    return std::min(m, 0.5);
}

static Guard central_guard(const Run &run)
{
    CentralErrors e = central_errors(all_passes(run), run.settings);
    Guard guard;
    guard.promises = e.spread < WIDEST_SPREAD;
    e.spread = std::min(e.spread, WIDEST_SPREAD);
    double more = 1 / (1 - e.spread - 2 * e.mean) + 8 * UNIT_ROUNDOFF;
    guard.spread = more * e.spread + 8 * UNIT_ROUNDOFF;
    guard.variance = more * e.moved;
    // With the adding of it, and what the depth's own store takes.
    guard.mean = more * (e.mean + UNIT_ROUNDOFF + store_share(run.settings));
    guard.variance_fixed = guard.mean_fixed = more * e.tiny;
    return guard;
}

static double raw_fixed(const Run &run, const std::vector<MergePass> &passes)
{
    double fixed = 0;
    if (run.settings.sat) {
        double n = 2 * run.settings.radius + 1;
        double steps = std::exp2(std::floor(std::log2(0xffffffffu / (n * n))));
        fixed = 0.5 / steps + 24 * UNIT_ROUNDOFF;
    }
    for (const MergePass &pass : passes)
        fixed += pass.two ? 3 * UNIT_ROUNDOFF : 0;
    return fixed;
}

// Step 5's lesson has a closed form: (N + 1) u M1 and 3 (N + 1) u M2 of N
// roundings before a bilinear lookup, and a hundredth more.
static bool is_plain(const Settings &settings)
{
    return settings.msaa == 1 && !settings.half && !settings.mips &&
           !settings.sat && settings.blur != Blur::BOXES;
}

static Guard plain_guard(const Run &run)
{
    double u = 1.01 * UNIT_ROUNDOFF, roundings = 0;
    for (const MergePass &pass : filter_passes(run.settings))
        roundings += pass.taps + (pass.defect > 0 ? 1 : 0);
    Guard guard;
    guard.mean = u * (roundings + 1);
    guard.variance = 3 * guard.mean;
    guard.mean_fixed = 6 * u;
    guard.variance_fixed = 18 * u;
    return guard;
}

static Guard raw_guard(const Run &run)
{
    if (is_plain(run.settings))
        return plain_guard(run);
    std::vector<MergePass> passes = all_passes(run);
    double u = UNIT_ROUNDOFF, s = store_share(run.settings), growth = 1;
    double tiny = UNDERFLOW + store_absolute(run.settings);
    for (const MergePass &pass : passes) {
        growth *= std::pow(1 + u, pass.taps) * (1 + pass.defect) *
                  (pass.stored ? 1 + s : 1);
        tiny += (2 + pass.taps) * UNDERFLOW +
                (pass.stored ? store_absolute(run.settings) : 0);
    }
    double e = growth - 1;
    double e2 = growth * (1 + u) * (1 + s) / ((1 - s) * (1 - s)) - 1;
    double k = e2 + 2 * e + e * e + 2 * u * (1 + e2) * (1 + e) * (1 + e);
    double fixed = raw_fixed(run, passes) * (1 + e2);
    double more = 1 / (1 - k - e) + 8 * u;
    Guard guard;
    guard.variance = more * k;
    guard.variance_fixed = more * (3 * fixed * (1 + e + fixed + k) + 4 * tiny);
    guard.mean = more * (e + u);
    guard.mean_fixed = more * (fixed + 2 * tiny);
    return guard;
}

Guard guard_of(const Run &run)
{
    if (run.step != 5 || !run.settings.auto_variance)
        return {};
    return run.settings.central ? central_guard(run) : raw_guard(run);
}
