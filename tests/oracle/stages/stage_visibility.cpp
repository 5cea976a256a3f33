#include <algorithm> // max
#include <cmath>     // abs, floor

#include "tests/oracle/filters/box_lookup.h"
#include "tests/oracle/filters/chebyshev_bound.h"
#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/dump/light.h"
#include "tests/oracle/filters/mip_levels.h"
#include "tests/oracle/stages/pcf_width.h"
#include "tests/oracle/filters/poisson_disc.h"
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/stages/soft_lookup.h"
#include "tests/oracle/stages/spread.h"
#include "tests/oracle/stages/stage.h"

// A pixel whose interval is wider than this proves nothing: untested.
static constexpr double WIDEST = 0.1;
// More untested pixels than this share mean that the check tests too little.
static constexpr double MOST_UNTESTED = 0.02;
// The hardware's sampler may take other taps than ours, besides another level:
// at edges finer than a tap this share may differ by more than 1/255.
static constexpr double MOST_OTHER_TAPS = 0.02;
// A difference that an 8-bit picture shows.
static constexpr double VISIBLE = 1.0 / 255;

static double texel(const Picture &map, int x, int y, int channel)
{
    return map.holds(x, y) ? double(map.at(x, y, channel)) : 1.0;
}

// 1 where t - bias <= depth for sure, 0 where it is not for sure, else both.
static Interval compared(double t, Interval bias, Interval depth)
{
    Interval moved = t - bias;
    if (bias.hi > 0) // t - 0 is exact
        moved = widened(moved, UNIT_ROUNDOFF * (t + bias.hi));
    if (moved.hi <= depth.lo)
        return 1;
    return moved.lo > depth.hi ? Interval(0) : Interval(0, 1);
}

static Interval pcf_at(const Receiver &r, Interval bias, const Picture &map,
                       int centre_x, int centre_y, int n)
{
    Interval lit = 0;
    int half = (n - 1) / 2;
    for (int y = centre_y - half; y <= centre_y + half; y++)
        for (int x = centre_x - half; x <= centre_x + half; x++)
            lit = lit + compared(r.t, bias, texel(map, x, y, 0));
    // A whole number is exact in float; the product with 1/n^2 is not.
    return n == 1 ? lit : rounded(lit / double(n * n), rounding_share(3));
}

// Steps 1 and 2. The product u * size is rounded before floor, so a position
// next to a texel's edge can belong to either texel.
static Interval pcf(const Receiver &r, const MapView &view, const Picture &map,
                    const Settings &settings)
{
    int n = settings.kernel;
    Interval bias = total_bias(r, view, map.width, map.height, n, settings);
    Interval x = rounded(r.u * map.width, UNIT_ROUNDOFF);
    Interval y = rounded(r.v * map.height, UNIT_ROUNDOFF);
    int left = int(std::floor(x.lo)), right = int(std::floor(x.hi));
    int low = int(std::floor(y.lo)), high = int(std::floor(y.hi));
    Interval lit = pcf_at(r, bias, map, left, low, n);
    for (int j = low; j <= high; j++)
        for (int i = left; i <= right; i++)
            lit = hull(lit, pcf_at(r, bias, map, i, j, n));
    return lit;
}

// Step 2 with --bilinear. Each of the n x n lookups rounds its weights and two
// nested blends (absolute: at most 1), then n^2 positive numbers are added.
static Interval soft_pcf(const Receiver &r, const MapView &view,
                         const Picture &map, const Settings &settings)
{
    int n = settings.kernel;
    Interval bias = total_bias(r, view, map.width, map.height, n, settings);
    Shifts shifts = lookup_shifts(r.u, r.v, map.width, map.height);
    double least = INFINITY, most = 0;
    for (double dy : shifts.y)
        for (double dx : shifts.x) {
            Footprint up = tap_footprint(r.v, dy, map.height, settings);
            Footprint across = tap_footprint(r.u, dx, map.width, settings);
            Interval lit = 0;
            for (size_t j = 0; j < up.weights.size(); j++)
                for (size_t i = 0; i < across.weights.size(); i++) {
                    double depth =
                        texel(map, across.first + int(i), up.first + int(j), 0);
                    double weight = across.weights[i] * up.weights[j];
                    lit = lit + weight * compared(r.t, bias, depth);
                }
            least = std::min(least, lit.lo);
            most = std::max(most, lit.hi);
        }
    return widened({least, most}, rounding_share(n * n + 8));
}

// The comparison with the texel at (x, y), each right to `error`: rounding can
// move it across a texel's edge.
static Interval tap_at(const Receiver &r, Interval bias, const Picture &map,
                       glm::dvec2 place, glm::dvec2 error)
{
    glm::dvec2 low = glm::floor(place - error),
               high = glm::floor(place + error);
    Interval lit = compared(r.t, bias, texel(map, int(low.x), int(low.y), 0));
    for (int y = int(low.y); y <= int(high.y); y++)
        for (int x = int(low.x); x <= int(high.x); x++)
            lit = hull(lit, compared(r.t, bias, texel(map, x, y, 0)));
    return lit;
}

// Step 2 with --pattern poisson: a disc of diameter n. A turned tap is the sum
// of two products of rounded numbers, at most sqrt(2) together: 6 roundings.
// The radius times that, u * size and their sum are rounded once more each.
// A count of 32 and a 32nd of it are exact.
static Interval disc_pcf(const Receiver &r, const MapView &view,
                         const Picture &map, int x, int y,
                         const Settings &settings)
{
    int n = settings.kernel;
    Interval bias = total_bias(r, view, map.width, map.height, n, settings);
    glm::dvec2 centre(r.u * map.width, r.v * map.height);
    glm::dvec2 error = UNIT_ROUNDOFF * (2.0 * glm::abs(centre) + 8 * n / 2.0);
    Interval lit = 0;
    for (const glm::dvec2 &tap : poisson_taps(x, y))
        lit = lit + tap_at(r, bias, map, centre + n / 2.0 * tap, error);
    return lit / double(POISSON_TAPS);
}

static double bilinear(const Picture &map, double x, double y, int channel)
{
    double left = std::floor(x), low = std::floor(y);
    double wx = x - left, wy = y - low;
    int i = int(left), j = int(low);
    double below = (1 - wx) * texel(map, i, j, channel) +
                   wx * texel(map, i + 1, j, channel);
    double above = (1 - wx) * texel(map, i, j + 1, channel) +
                   wx * texel(map, i + 1, j + 1, channel);
    return (1 - wy) * below + wy * above;
}

// The largest of the texels that a lookup at x, y can touch.
static double largest(const Picture &map, double x, double y, int channel)
{
    double value = 0;
    int i = int(std::floor(x)), j = int(std::floor(y));
    for (int dy = -1; dy <= 2; dy++)
        for (int dx = -1; dx <= 2; dx++)
            value = std::max(value, texel(map, i + dx, j + dy, channel));
    return value;
}

// A lookup is bilinear between texel centres, so that over a small rectangle
// of positions its extremes lie at the corners or where a texel centre cuts.
static Interval looked_up(const Picture &map, const Receiver &r, int channel)
{
    double x = r.u * map.width - 0.5, y = r.v * map.height - 0.5;
    Shifts shifts = lookup_shifts(r.u, r.v, map.width, map.height);
    Interval value = bilinear(map, x, y, channel);
    for (double dy : shifts.y)
        for (double dx : shifts.x)
            value = hull(value, bilinear(map, x + dx, y + dy, channel));
    double share = rounding_share(LOOKUP_ROUNDINGS);
    return widened(value, share * largest(map, x, y, channel));
}

namespace
{

// One pixel of the picture, and what it looks up.
struct Pixel {
    int x, y;
    const std::vector<Picture> &maps; // by layer
    const MipLookup &mips;
    const BoxLookup &boxes;
    const PcfWidth &widths;
    const Formula &formula;
    const SoftLookup &soft;
};

} // namespace

// Mean and variance as the program may have looked them up.
static Spread central(const Run &run, const Receiver &r, const Pixel &pixel)
{
    if (run.settings.mips)
        return pixel.mips.spread(r, pixel.x, pixel.y);
    const Picture &map = pixel.maps[size_t(r.layer)];
    Shifts shifts = lookup_shifts(r.u, r.v, map.width, map.height);
    return looked_up_spread(map, r.u * map.width - 0.5, r.v * map.height - 0.5,
                            shifts.x, shifts.y);
}

// M1 or M2 likewise.
static Interval moment(const Run &run, const Receiver &r, const Pixel &pixel,
                       int channel)
{
    if (run.settings.mips)
        return pixel.mips.moment(r, pixel.x, pixel.y, channel);
    if (run.settings.adaptive_box)
        return pixel.boxes.moment(r, pixel.x, pixel.y, channel);
    Interval value = looked_up(pixel.maps[size_t(r.layer)], r, channel);
    // The dumped box and the one looked up each have the table's error.
    return widened(value, 2 * table_absolute(run.settings));
}

static Moments moments(const Run &run, const Receiver &r, const Pixel &pixel)
{
    if (!run.settings.central)
        return {moment(run, r, pixel, 0), moment(run, r, pixel, 1)};
    Spread spread = central(run, r, pixel);
    return {spread.mean, spread.variance};
}

// Step 2, over the widths that the pixel can have chosen.
static Interval pcf_anyhow(const Run &run, const Receiver &r,
                           const MapView &view, const Pixel &pixel)
{
    const Picture &map = pixel.maps[size_t(r.layer)];
    Settings settings = run.settings;
    Interval lit(1, 0);
    for (int width :
         pixel.widths.at(r, pixel.x, pixel.y, map.width, map.height)) {
        settings.kernel = width;
        Interval here = settings.poisson
                            ? disc_pcf(r, view, map, pixel.x, pixel.y, settings)
                        : settings.bilinear ? soft_pcf(r, view, map, settings)
                                            : pcf(r, view, map, settings);
        lit = {std::min(lit.lo, here.lo), std::max(lit.hi, here.hi)};
    }
    return lit;
}

// The visibility of a receiver inside the map that faces the light.
static Interval expected(const Run &run, const Receiver &r, const MapView &view,
                         const Pixel &pixel)
{
    const Settings &settings = run.settings;
    const Picture &map = pixel.maps[size_t(r.layer)];
    if (run.step <= 2)
        return pcf_anyhow(run, r, view, pixel);
    if (settings.soft)
        return pixel.soft.visibility(r, pixel.x, pixel.y);
    Moments m = moments(run, r, pixel);
    if (run.step == 5)
        return chebyshev(m, r.t, depth_noise(view, r.position), pixel.formula);
    Interval bias = total_bias(r, view, map.width, map.height, 1, settings);
    return compared(r.t, bias, m.m1);
}

// What the map does not hold is lit.
static Interval in_layer(const Run &run, const Receiver &r, const Pixel &pixel)
{
    size_t layer = size_t(r.layer);
    return run.settings.shadows && layer < run.views.size() && inside_map(r)
               ? expected(run, r, run.views[layer], pixel)
               : Interval(1);
}

static Interval expected_anywhere(const Run &run, const Receiver &r,
                                  const Pixel &pixel)
{
    if (!r.shown)
        return 1;
    Facing side = facing(r, run.views[size_t(r.layer)]);
    if (side == Facing::AWAY)
        return 0;
    Interval lit = in_layer(run, r, pixel);
    if (r.share > 0) { // a product each, a difference and a sum
        Interval next = in_layer(run, r.in_next(), pixel);
        lit = (1 - r.share) * lit + r.share * next;
        lit = widened(lit, rounding_share(4));
    }
    return side == Facing::UNKNOWN ? hull(0, lit) : lit;
}

// --sampler hardware: within a level of the explicit lookup. What level 0 alone
// would show as well tells nothing about levels, so there have to be enough
// other pixels, and they count apart.
static void check_hardware(const Run &run, Report &report)
{
    Run finest = run;
    finest.settings.mips = false;
    Receivers receivers(run);
    std::vector<Picture> maps;
    MipLookup mips(run);
    BoxLookup boxes(run);
    PcfWidth widths(run);
    Formula formula(run);
    SoftLookup soft(run, formula);
    size_t shown = 0, outside = 0, telling = 0, level_0 = 0;
    double worst = 0;
    for (int layer = 0; layer < int(run.views.size()); layer++)
        maps.push_back(load_filtered(run, layer));
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            Pixel pixel = {x, y, maps, mips, boxes, widths, formula, soft};
            Interval truth = expected_anywhere(run, r, pixel);
            Interval plain = expected_anywhere(finest, r, pixel);
            double distance = truth.distance(r.visibility);
            bool tells = truth.distance(plain.lo) > VISIBLE &&
                         truth.distance(plain.hi) > VISIBLE;
            shown += r.shown ? 1 : 0;
            outside += distance > VISIBLE ? 1 : 0;
            telling += tells ? 1 : 0;
            level_0 += tells && distance > VISIBLE ? 1 : 0;
            worst = std::max(worst, distance);
        }
    double share = shown ? double(outside) / double(shown) : 0;
    report.line(share <= MOST_OTHER_TAPS,
                "stage visibility: hardware sampler within one level",
                "%zu of %zu pixels not (%.3g %%), worst by %.3g", outside,
                shown, 100 * share, worst);
    report.line(telling > shown / 100 && level_0 <= telling / 4,
                "stage visibility: levels are looked up",
                "%zu of %zu pixels where level 0 would show are not", level_0,
                telling);
}

void for_each_expected(const Run &run, const UseExpected &use)
{
    Receivers receivers(run);
    std::vector<Picture> maps;
    for (size_t i = 0; run.settings.shadows && i < run.views.size(); i++)
        maps.push_back(load_filtered(run, int(i)));
    MipLookup mips(run);
    BoxLookup boxes(run);
    PcfWidth widths(run);
    Formula formula(run);
    SoftLookup soft(run, formula);
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            use(r,
                expected_anywhere(
                    run, r, {x, y, maps, mips, boxes, widths, formula, soft}));
        }
}

void check_visibility(const Run &run, Report &report)
{
    if (run.settings.hardware)
        return check_hardware(run, report);
    size_t shown = 0, untested = 0, wrong = 0;
    double worst = 0, widest = 0;
    for_each_expected(run, [&](const Receiver &r, Interval truth) {
        shown += r.shown ? 1 : 0;
        if (truth.width() > WIDEST) {
            untested++;
            return;
        }
        wrong += truth.contains(r.visibility) ? 0 : 1;
        worst = std::max(worst, truth.distance(r.visibility));
        widest = std::max(widest, truth.width());
    });
    size_t pixels = size_t(run.width) * size_t(run.height);
    report.line(wrong == 0, "stage visibility",
                "%zu of %zu tested pixels outside, worst by %.3g, widest "
                "interval %.3g",
                wrong, pixels - untested, worst, widest);
    report.line(double(untested) <= MOST_UNTESTED * double(shown),
                "stage visibility: few untested", "%zu of %zu pixels (%.3g %%)",
                untested, shown,
                shown ? 100.0 * double(untested) / double(shown) : 0.0);
}
