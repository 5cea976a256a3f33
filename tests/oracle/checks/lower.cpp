#include "tests/oracle/checks/lower.h"

#include <algorithm> // min, max
#include <cmath>     // INFINITY

#include "tests/oracle/filters/chebyshev_bound.h"
#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/dump/light.h"
#include "tests/oracle/lib/rounding.h"

// A bound wider than this proves nothing: untested.
static constexpr double WIDEST = 0.1;
// The oracle's own sums of some thousand weights, in double.
static constexpr double OWN_ROUNDING = 1e-12;

namespace
{

using Maps = std::vector<std::vector<Picture>>; // by layer, their samples

// What the whole filter sees at one position, from the samples as stored.
struct Seen {
    double lit = 0;        // weight of those at or behind the receiver
    double m1 = 0, m2 = 0; // exact, of the samples' own depths
    double variance = 0;   // and of those about m1; with auto not needed
    double farthest = 0;   // the largest depth with a weight
};

// The counts of one run over all pixels.
struct Tally {
    size_t tested = 0, untested = 0, violated = 0, penumbra = 0;
    double worst = INFINITY;   // smallest p - (lit - bound)
    double nearest = INFINITY; // smallest p - lit
    double widest = 0;         // largest bound used
};

} // namespace

static double texel(const Picture &map, int x, int y)
{
    return map.holds(x, y) ? double(map.at(x, y)) : 1.0;
}

// A texel's samples have equal shares of its weight.
static Seen seen(const std::vector<Picture> &samples, const Footprint &across,
                 const Footprint &up, double t)
{
    Seen sum;
    double share = 1 / double(samples.size());
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++) {
            double weight = share * across.weights[i] * up.weights[j];
            for (const Picture &map : samples) {
                double x = texel(map, across.first + int(i), up.first + int(j));
                sum.lit += x >= t ? weight : 0;
                sum.m1 += weight * x;
                sum.m2 += weight * x * x;
                sum.farthest = std::max(sum.farthest, weight > 0 ? x : 0);
            }
        }
    return sum;
}

// About m1: nothing cancels.
static double variance_seen(const std::vector<Picture> &samples,
                            const Footprint &across, const Footprint &up,
                            double m1)
{
    double variance = 0, share = 1 / double(samples.size());
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++) {
            double weight = share * across.weights[i] * up.weights[j];
            for (const Picture &map : samples) {
                double x = texel(map, across.first + int(i), up.first + int(j));
                variance += weight * (x - m1) * (x - m1);
            }
        }
    return variance;
}

// How far rounding can pull p below what exact arithmetic gives, and exact
// arithmetic gives at least `lit` (Cantelli). With auto: not at all, but for
// the formula's last operations (proof.md of step 5's guard).
static double bound_of_auto(const Formula &formula)
{
    return formula.guard.promises ? rounding_share(12) + OWN_ROUNDING
                                  : INFINITY;
}

// Of central moments: mean and deviation are off by no more than this, and then
// what chebyshev() rounds.
static double bound_of_central(const Run &run, const Seen &s, double t,
                               const Formula &formula)
{
    Run guarded = run;
    guarded.settings.auto_variance = true;
    Guard e = guard_of(guarded);
    double deviation = std::sqrt(s.variance);
    Interval mean = widened(s.m1, e.mean * rounded_part(s.m1) +
                                      e.spread * deviation + e.mean_fixed);
    Interval wide =
        widened(deviation, e.spread * deviation +
                               e.variance * rounded_part(std::sqrt(s.m2)) +
                               e.mean_fixed);
    Interval variance = square(maximum(wide, 0));
    double exact = chebyshev_exact(s.m1, s.variance, t, 0, formula);
    Interval p = chebyshev({mean, variance}, t, 0, formula);
    return exact - std::min(exact, p.lo) + OWN_ROUNDING;
}

// Of raw ones: M2 of each sample, their mean by resolve_share, the downsampling
// and the blur by blur_share, the lookup by 6 units of the largest texel it
// blends, then the formula's own, in chebyshev().
static double bound(const Run &run, const Seen &s, double t,
                    const Formula &formula)
{
    const Settings &settings = run.settings;
    if (settings.auto_variance)
        return bound_of_auto(formula);
    if (settings.central)
        return bound_of_central(run, s, t, formula);
    double blur = blur_share(settings) + 1.01 * resolve_share(settings);
    double lookup = rounding_share(LOOKUP_ROUNDINGS);
    double far2 = s.farthest * s.farthest;
    double tiny = blur_absolute(settings) + store_absolute(settings) +
                  resolve_absolute(settings);
    Interval m1 = widened(s.m1, blur * s.m1 + lookup * s.farthest + tiny);
    // The stored M1 is rounded too, and M2 is the square of what it was.
    double m2_share = blur + UNIT_ROUNDOFF + 3 * store_share(settings);
    Interval m2 = widened(s.m2, m2_share * s.m2 + lookup * far2 + 3 * tiny);
    double exact = chebyshev_exact(s.m1, s.variance, t, 0, formula);
    return exact - std::min(exact, chebyshev({m1, m2}, t, 0, formula).lo) +
           OWN_ROUNDING;
}

// The least lit share over the widened position, with and without the bound.
struct Least {
    double bounded = 1, lit = 1, widest = 0;
};

static Least least_of(const Run &run, const Receiver &r, const Maps &maps,
                      const Formula &formula)
{
    if (size_t(r.layer) >= maps.size() || !inside_map(r))
        return {};
    const MapView &view = run.views[size_t(r.layer)];
    const std::vector<Picture> &map = maps[size_t(r.layer)];
    const Settings &settings = run.settings;
    int f = settings.downsample;
    Shifts shifts = lookup_shifts(r.u, r.v, view.width / f, view.height / f);
    double least = INFINITY, lit = INFINITY, widest = 0;
    for (double dy : shifts.y) { // the least over the widened position
        Footprint up = lookup_footprint(r.v, dy, view.height, settings);
        for (double dx : shifts.x) {
            Footprint across = lookup_footprint(r.u, dx, view.width, settings);
            Seen s = seen(map, across, up, r.t);
            if (!settings.auto_variance)
                s.variance = variance_seen(map, across, up, s.m1);
            double rounding = bound(run, s, r.t, formula);
            least = std::min(least, s.lit - rounding);
            lit = std::min(lit, s.lit);
            widest = std::max(widest, rounding);
        }
    }
    return {least, lit, widest};
}

static void test_pixel(const Run &run, const Receiver &r, const Maps &maps,
                       const Formula &formula, Tally &tally)
{
    Least l = least_of(run, r, maps, formula);
    if (r.share > 0) { // two splits are mixed
        Least next = least_of(run, r.in_next(), maps, formula);
        double own = 1 - r.share, rounding = rounding_share(4);
        l = {own * l.bounded + r.share * next.bounded - rounding,
             own * l.lit + r.share * next.lit, std::max(l.widest, next.widest)};
    }
    if (l.widest > WIDEST) {
        tally.untested++;
        return;
    }
    tally.tested++;
    tally.penumbra += l.lit > 0.01 && l.lit < 0.99 ? 1 : 0;
    tally.violated += r.visibility >= l.bounded ? 0 : 1; // true for NaN too
    tally.worst = std::min(tally.worst, r.visibility - l.bounded);
    tally.nearest = std::min(tally.nearest, r.visibility - l.lit);
    tally.widest = std::max(tally.widest, l.widest);
}

void check_lower(const Run &run, Report &report)
{
    if (run.step != 5 || run.settings.reduces() || run.settings.soft)
        throw BadInput("lower needs step 5 without a reduction or --soft");
    if (run.settings.mips || run.settings.adaptive_box)
        throw BadInput("lower knows only filters that are alike everywhere");
    Receivers receivers(run);
    Maps maps;
    for (size_t layer = 0; layer < run.views.size(); layer++)
        maps.push_back(load_samples(run, int(layer)));
    Formula formula(run);
    Tally tally;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown || !inside_map(r))
                continue;
            if (facing(r, run.views[size_t(r.layer)]) == Facing::TOWARDS)
                test_pixel(run, r, maps, formula, tally);
        }
    report.line(tally.violated == 0 && tally.tested > 0,
                "p_max is not below the lit share",
                "%zu of %zu violate (%zu in penumbra), worst margin %.3g "
                "(%.3g without the bound), widest bound %.3g, %zu untested",
                tally.violated, tally.tested, tally.penumbra, tally.worst,
                tally.nearest, tally.widest, tally.untested);
}
