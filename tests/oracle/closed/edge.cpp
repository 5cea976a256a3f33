#include <algorithm> // max, min
#include <cmath>     // abs, sqrt

#include "tests/oracle/filters/chebyshev_bound.h"
#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/dump/light.h"
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/closed/two_depths.h"

// A bound wider than this proves nothing: untested.
static constexpr double WIDEST = 0.1;

namespace
{

struct EdgeMap {
    MapView view;
    Settings settings;
    Formula formula;
    Guard central_errors;
    int step;
    double floor, occluder; // depths t
    double depth_error;     // of a 32-bit depth, rasterised or of a pixel
    double texel_error;     // of the depths that the map has, measured
    // Per texel: the share of its samples that see the floor; UNKNOWN where one
    // may see either, or something else.
    std::vector<double> sees_floor;
    static constexpr double UNKNOWN = -1;

    double sees(int x, int y) const
    {
        return sees_floor[size_t(y) * size_t(view.width) + size_t(x)];
    }
};

// What one pixel should be, and how far off it may be.
struct Prediction {
    bool testable = false;
    double share = 0; // of the filter that sees past the occluder
    double lit = 1;
    double bound = 0;
};

struct Tally {
    size_t tested = 0, wrong = 0, penumbra = 0, untested = 0, hidden = 0;
    double worst = 0, widest = 0;
    double left = 0; // of the light, at most, where the filter is covered

    void add(const Prediction &prediction, double visibility)
    {
        if (prediction.testable && prediction.lit == 0) {
            hidden++;
            left = std::max(left, visibility);
        }
        if (!prediction.testable || prediction.bound > WIDEST) {
            untested++;
            return;
        }
        double error = std::abs(visibility - prediction.lit);
        tested++;
        wrong += error <= prediction.bound ? 0 : 1;
        penumbra += prediction.share > 0 && prediction.share < 1 ? 1 : 0;
        worst = std::max(worst, error);
        widest = std::max(widest, prediction.bound);
    }
};

} // namespace

// The weight of the texels that see the floor past the occluder. False when
// the filter sees anything else, or a texel that may be either.
static bool uncovered(const EdgeMap &map, const Footprint &across,
                      const Footprint &up, double &share)
{
    share = 0;
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++) {
            int x = across.first + int(i), y = up.first + int(j);
            double weight = across.weights[i] * up.weights[j];
            if (weight == 0)
                continue;
            if (x < 0 || y < 0 || x >= map.view.width || y >= map.view.height)
                return false;
            double sees = map.sees(x, y);
            if (sees == EdgeMap::UNKNOWN)
                return false;
            share += weight * sees;
        }
    share = std::min(share, 1.0); // the weights' own sum is rounded
    return true;
}

// The texels under the filter are known: rounding cannot move it to others.
static bool certain(const EdgeMap &map, const Receiver &r)
{
    Interval x = rounded(r.u * map.view.width, UNIT_ROUNDOFF);
    Interval y = rounded(r.v * map.view.height, UNIT_ROUNDOFF);
    return map.settings.bilinear || (std::floor(x.lo) == std::floor(x.hi) &&
                                     std::floor(y.lo) == std::floor(y.hi));
}

// How far rounding the position can move a bilinear filter's share.
static bool share_moves(const EdgeMap &map, const Receiver &r, double &most)
{
    most = 0;
    if (!map.settings.bilinear)
        return true;
    double share = 0, moved = 0;
    const Settings &s = map.settings;
    if (!uncovered(map, tap_footprint(r.u, 0, map.view.width, s),
                   tap_footprint(r.v, 0, map.view.height, s), share))
        return false;
    Shifts shifts = lookup_shifts(r.u, r.v, map.view.width, map.view.height);
    for (double dy : shifts.y)
        for (double dx : shifts.x) {
            if (!uncovered(map, tap_footprint(r.u, dx, map.view.width, s),
                           tap_footprint(r.v, dy, map.view.height, s), moved))
                return false;
            most = std::max(most, std::abs(moved - share));
        }
    return true;
}

// Steps 1 and 2: the share of taps that the receiver is not behind.
static Prediction predict_taps(const EdgeMap &map, const Receiver &r,
                               double own_depth)
{
    const Settings &s = map.settings;
    const MapView &view = map.view;
    Prediction prediction;
    double share = 0, moves = 0;
    if (!certain(map, r) || !share_moves(map, r, moves) ||
        !uncovered(map, tap_footprint(r.u, 0, view.width, s),
                   tap_footprint(r.v, 0, view.height, s), share))
        return prediction;
    Interval bias = total_bias(r, view, view.width, view.height, s.kernel, s);
    Interval slack = widened(bias - own_depth, 2 * map.depth_error);
    bool floor_clear = (slack + map.floor).lo > 0;
    bool occluder_clear = (slack + map.occluder).lo > 0;
    bool occluder_dark = (slack + map.occluder).hi < 0;
    prediction.testable =
        floor_clear && (occluder_clear || occluder_dark || share == 1);
    prediction.share = share;
    prediction.lit = occluder_clear ? 1 : share;
    int n = s.kernel; // k times 1/n^2, or n^2 blends and their sum
    prediction.bound = rounding_share(s.bilinear ? n * n + 8 : 3) + moves;
    return prediction;
}

// Of central moments: the filter's and the lookup's errors as in guard.h, and
// of each texel's depth by e.
static Moments central_moments(const EdgeMap &map, double m1, double m2,
                               double deviation)
{
    const Guard &g = map.central_errors;
    double e = map.texel_error;
    double off = e + g.spread * deviation + g.mean_fixed;
    Interval mean = widened(m1, off + g.mean * rounded_part(m1));
    off += g.variance * rounded_part(std::sqrt(m2));
    Interval root = maximum(widened(deviation, off), 0);
    return {mean, square(root)};
}

// The interval of p when a share q of the filter sees the floor. Exact
// arithmetic gives p = q for a receiver at the floor's depth. What is rounded:
// - M1 and M2 by a texel's mean, the blur and the lookup, and M2's square;
// - each texel's depth by at most e: that moves M1 by e, as if t had moved,
//   and the variance by at most 2 e sd + e^2;
// - t itself, which the receiver file has.
// The variance is a difference of numbers of size M2, so all this is amplified
// by its condition number M2 / variance.
static Interval p_interval(const EdgeMap &map, double q, double t, double noise)
{
    double near = map.occluder, far = map.floor, e = map.texel_error;
    double m1 = q * far + (1 - q) * near;
    double m2 = q * far * far + (1 - q) * near * near;
    double deviation = std::sqrt(q * (1 - q)) * (far - near);
    if (map.settings.central)
        return chebyshev(central_moments(map, m1, m2, deviation), t, noise,
                         map.formula);
    // The map's own store comes before the filter's.
    double blur = blur_share(map.settings) + 1.01 * store_share(map.settings) +
                  1.01 * resolve_share(map.settings);
    double tiny = blur_absolute(map.settings) + store_absolute(map.settings) +
                  resolve_absolute(map.settings);
    double lookup = rounding_share(LOOKUP_ROUNDINGS);
    Interval wide_m1 = widened(m1, blur * m1 + lookup * far + tiny);
    Interval wide_m2 =
        widened(m2, (blur + UNIT_ROUNDOFF) * m2 + lookup * far * far +
                        2 * e * deviation + e * e + tiny);
    return chebyshev({wide_m1, wide_m2}, t, noise, map.formula);
}

static Prediction predict_moments(const EdgeMap &map, const Receiver &r,
                                  double own_depth)
{
    int f = map.settings.downsample;
    const MapView &view = map.view;
    Prediction prediction;
    double least = 1, most = 0, q = 0;
    Shifts shifts = lookup_shifts(r.u, r.v, view.width / f, view.height / f);
    for (double dy : shifts.y)
        for (double dx : shifts.x) {
            if (!uncovered(
                    map, lookup_footprint(r.u, dx, view.width, map.settings),
                    lookup_footprint(r.v, dy, view.height, map.settings), q))
                return prediction;
            Interval p = p_interval(map, q, r.t, depth_noise(view, r.position));
            least = std::min(least, p.lo);
            most = std::max(most, p.hi);
        }
    bool on_floor = own_depth == map.floor;
    double a = map.settings.bleed_reduction;
    if (!uncovered(map, lookup_footprint(r.u, 0, view.width, map.settings),
                   lookup_footprint(r.v, 0, view.height, map.settings), q))
        return prediction;
    prediction.testable = true;
    prediction.share = q;
    prediction.lit = on_floor ? std::clamp((q - a) / (1 - a), 0.0, 1.0) : 1.0;
    prediction.bound = std::max(
        {std::abs(most - prediction.lit), std::abs(prediction.lit - least)});
    return prediction;
}

// What EdgeMap::sees_floor has of the texel with this lower left corner.
static double floor_share(const MapRectangle &floor,
                          const MapRectangle &occluder,
                          const std::vector<glm::dvec2> &samples,
                          const glm::dvec2 &corner)
{
    double count = 0;
    for (const glm::dvec2 &sample : samples) {
        Place place = occluder.place(corner + sample);
        if (floor.place(corner + sample) != Place::INSIDE ||
            place == Place::AMBIGUOUS)
            return EdgeMap::UNKNOWN;
        count += place == Place::OUTSIDE ? 1 : 0;
    }
    return count / double(samples.size());
}

// What auto adds is what can be lost, whether it is added or not.
static Guard errors_of_all(const Run &run)
{
    Run guarded = run;
    guarded.settings.auto_variance = true;
    return guard_of(guarded);
}

// How far the map's depths are off: 16-bit floats round them too.
static double texel_error(const Run &run, const EdgeMap &map)
{
    Picture texels = load_map(run, 0);
    double worst = 0;
    for (int y = 0; y < texels.height; y++)
        for (int x = 0; x < texels.width; x++) {
            double q = map.sees(x, y);
            double depth = q * map.floor + (1 - q) * map.occluder;
            if (q != EdgeMap::UNKNOWN)
                worst = std::max(worst, std::abs(texels.at(x, y, 0) - depth));
        }
    return worst;
}

// As few units as a depth can be off, and the receivers' own.
static void check_depths(const Run &run, const EdgeMap &map, Report &report)
{
    Receivers receivers(run);
    double stored = map.depth_error + store_share(map.settings);
    double worst = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (r.shown && inside_map(r))
                worst = std::max(worst, std::min(std::abs(r.t - map.floor),
                                                 std::abs(r.t - map.occluder)));
        }
    report.line(map.texel_error <= stored && worst <= map.depth_error,
                "edge: depths are one of two",
                "off by up to %.3g in the map, %.3g in the picture",
                map.texel_error, worst);
}

static EdgeMap edge_map(const Run &run, const SceneTable &table)
{
    if (run.step > 2 && run.step != 5)
        throw BadInput("edge needs step 1, 2 or 5");
    MapRectangle floor(table, run, "floor");
    MapRectangle occluder(table, run, "occluder");
    EdgeMap map{run.views.at(0),
                run.settings,
                Formula(run),
                errors_of_all(run),
                run.step,
                floor.depth(),
                occluder.depth(),
                0,
                0,
                {}};
    for (int y = 0; y < map.view.height; y++)
        for (int x = 0; x < map.view.width; x++)
            map.sees_floor.push_back(
                floor_share(floor, occluder, run.places, {x, y}));
    // The vertices' rounding, the blend of three and the dot product with T:
    // 16 units of the numbers' size, as for the ray cast depths.
    double extent = scene_extent(table.scene, run.origin);
    double size = std::abs(map.view.rows[2].w) + 1;
    for (int i = 0; i < 3; i++)
        size += std::abs(map.view.rows[2][i]) * extent;
    map.depth_error = rounding_share(16) * size;
    if (run.step == 5)
        map.texel_error = texel_error(run, map);
    double rounding = run.step == 5 ? map.texel_error : map.depth_error;
    if (map.floor - map.occluder < 4 * rounding)
        throw BadInput("edge: the gap is lost in the rounding of depths");
    return map;
}

static void print(const char *what, const Tally &t, bool wants_penumbra,
                  Report &report)
{
    bool tested = t.tested > 0 && t.tested >= t.untested &&
                  (t.penumbra > 0 || !wants_penumbra);
    bool hidden = t.tested + t.untested == 0; // not in this picture
    report.line(t.wrong == 0 && (tested || (hidden && !wants_penumbra)), what,
                "%zu of %zu pixels outside the bound (%zu with a mixed "
                "filter), worst %.3g, widest bound %.3g, %zu untested; %.3g "
                "left in full shadow (%zu)",
                t.wrong, t.tested, t.penumbra, t.worst, t.widest, t.untested,
                t.left, t.hidden);
}

// With --msaa a texel is between both depths by steps of 1 / N. Each sample's
// depth is off by the rasteriser's rounding and its store, their mean by its
// own.
static void check_edge_texels(const Run &run, const EdgeMap &map,
                              Report &report)
{
    Picture moments = load_map(run, 0);
    double gap = map.floor - map.occluder, worst = 0;
    double rounding = map.depth_error + resolve_absolute(run.settings) +
                      store_absolute(run.settings) +
                      map.floor * (resolve_share(run.settings) +
                                   1.01 * store_share(run.settings));
    size_t tested = 0, mixed = 0, wrong = 0;
    for (int y = 0; y < moments.height; y++)
        for (int x = 0; x < moments.width; x++) {
            double share = map.sees(x, y);
            if (share == EdgeMap::UNKNOWN)
                continue;
            double mean = map.occluder + share * gap;
            double error = std::abs(double(moments.at(x, y)) - mean);
            tested++;
            mixed += share > 0 && share < 1 ? 1 : 0;
            wrong += error <= rounding ? 0 : 1;
            worst = std::max(worst, error);
        }
    report.line(wrong == 0 && mixed > 0,
                "edge: a texel's mean is that of its samples",
                "%zu of %zu texels off (%zu of both depths), worst by %.3g, "
                "rounding %.3g",
                wrong, tested, mixed, worst, rounding);
}

void check_edge(const Run &run, const SceneTable &table, Report &report)
{
    EdgeMap map = edge_map(run, table);
    if (run.step == 5)
        check_depths(run, map, report);
    Receivers receivers(run);
    Tally on_floor, on_occluder;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown || !inside_map(r) ||
                facing(r, map.view) != Facing::TOWARDS)
                continue;
            bool floor =
                std::abs(r.t - map.floor) <= std::abs(r.t - map.occluder);
            double depth = floor ? map.floor : map.occluder;
            Prediction prediction = map.step == 5
                                        ? predict_moments(map, r, depth)
                                        : predict_taps(map, r, depth);
            (floor ? on_floor : on_occluder).add(prediction, r.visibility);
        }
    if (on_floor.tested + on_floor.untested == 0)
        throw BadInput("edge: no pixel shows the floor inside the map");
    // A kernel of one tap has no penumbra.
    bool soft = run.step == 5 || run.settings.kernel > 1;
    print("edge: visibility is the lit share", on_floor, soft, report);
    print("edge: the occluder's top is lit", on_occluder, false, report);
    if (run.settings.msaa > 1)
        check_edge_texels(run, map, report);
}
