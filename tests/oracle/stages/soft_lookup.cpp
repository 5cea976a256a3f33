#include "tests/oracle/stages/soft_lookup.h"

#include <cmath> // abs, exp2, floor, log2, sqrt

#include "tests/oracle/filters/depth_lookup.h" // between_levels
#include "tests/oracle/dump/light.h"
#include "tests/oracle/filters/mip_levels.h"
#include "tests/oracle/filters/poisson_disc.h"
#include "tests/oracle/lib/rounding.h"

static constexpr double LEAST_WIDTH = 4, LARGEST_PART = 1.0 / 8;
static constexpr double LEAST_HIDDEN = 0.01;
static constexpr double TAP_RADIUS = 0.1407;
// GLSL does not say how exact log2 and pow are on every driver.
static constexpr double LEVEL_ERROR = 1e-4, POWER_ERROR = 1e-5;
// Of the circle's image in the map, as a share: gradients of u and v from sums
// that cancel by up to 16 times, two normalised vectors, products and a root.
static constexpr double SHAPE_ERROR = 1e-5;
// A trilinear lookup: two bilinear ones of 6 each, their weights and a sum.
static constexpr int LOOKUP = 12;

// The levels that an explicit lookup uses: of a point light's face those that
// read nothing from beyond its border. Half the width of what one reads, by
// adding up: the blur, 1.5 texels of each level that was halved, and one of its
// own.
static std::vector<Picture> load_used_levels(const Run &run, int layer)
{
    std::vector<Picture> levels = load_levels(run, layer);
    const MapView &view = run.views[size_t(layer)];
    double free = std::floor(view.border / run.settings.downsample);
    double reach = run.settings.radius;
    for (size_t k = 0; k + 1 < levels.size(); k++) {
        reach += 1.5 * std::exp2(double(k));
        if (view.lamp == Lamp::POINT && reach + std::exp2(k + 1.0) > free)
            levels.resize(k + 1);
    }
    return levels;
}

SoftLookup::SoftLookup(const Run &run, const Formula &formula)
    : run_(run), formula_(formula)
{
    for (size_t i = 0; run.settings.soft && i < run.views.size(); i++)
        levels_.push_back(load_used_levels(run, int(i)));
}

namespace
{

// Where a step on the circle around a receiver goes in the map.
struct Shape {
    glm::dvec2 along, across; // texels per world unit
    double texels;            // the geometric mean of the ellipse's axes
};

} // namespace

// How u or v changes with a step: the derivative of U.p / W.p.
static double change(const glm::dvec4 &row, const glm::dvec4 &w,
                     const glm::dvec3 &p, const glm::dvec3 &step)
{
    double below = glm::dot(w, glm::dvec4(p, 1));
    double value = glm::dot(row, glm::dvec4(p, 1)) / below;
    return glm::dot(glm::dvec3(row) - value * glm::dvec3(w), step) / below;
}

// The first axis of the disc is the one along which u grows fastest. A step
// along the ray changes neither u nor v.
static Shape shape_at(const Receiver &r, const MapView &view,
                      const Picture &map)
{
    glm::dvec3 ray = glm::normalize(towards_light(view, r.position));
    glm::dvec3 grows;
    for (int k = 0; k < 3; k++) {
        glm::dvec3 unit(0);
        unit[k] = 1;
        grows[k] = change(view.rows[0], view.rows[3], r.position, unit);
    }
    glm::dvec3 first = glm::normalize(grows - glm::dot(grows, ray) * ray);
    glm::dvec3 second = glm::cross(ray, first);
    auto step = [&](const glm::dvec3 &direction) {
        return glm::dvec2(map.width * change(view.rows[0], view.rows[3],
                                             r.position, direction),
                          map.height * change(view.rows[1], view.rows[3],
                                              r.position, direction));
    };
    Shape shape{step(first), step(second), 0};
    shape.texels = std::sqrt(std::abs(shape.along.x * shape.across.y -
                                      shape.along.y * shape.across.x));
    return shape;
}

// World units from the light, of a parallel one from the near plane.
static Interval distance_of(const MapView &view, Interval t)
{
    double near = view.near, far = view.far;
    if (view.parallel())
        return rounded((far - near) * t, rounding_share(2));
    if (view.projected) // 1 / d is linear in t
        return rounded(near * far /
                           rounded(far - (far - near) * t, rounding_share(4)),
                       rounding_share(4));
    return rounded(near + (far - near) * t, rounding_share(4));
}

// The light's diameter as it is seen past an edge at one distance, at another.
static Interval width_of(const MapView &view, const Settings &settings,
                         Interval receiver, Interval occluder)
{
    Interval gap = receiver - occluder;
    if (!view.parallel())
        gap = gap / maximum(occluder, 1e-6 * receiver.lo);
    return rounded(settings.light_size * gap, rounding_share(6));
}

static Interval level_of(Interval texels)
{
    return {std::log2(std::max(texels.lo, 1.0)) - LEVEL_ERROR,
            std::log2(std::max(texels.hi, 1.0)) + LEVEL_ERROR};
}

SoftLookup::Before SoftLookup::looked_up(const Receiver &r, double u, double v,
                                         double error, Interval level) const
{
    const std::vector<Picture> &levels = levels_[size_t(r.layer)];
    bool central = run_.settings.central;
    return {between_levels(levels, u, v, error, level, {r.t, false, central}),
            between_levels(levels, u, v, error, level, {r.t, true, central})};
}

namespace
{

// What the formula gets, with the rounding of the lookups.
struct Found {
    Interval before, variance; // t - M1
    Moments moments;
};

} // namespace

// M1 and M2 are at most 1 and each right to a share; the variance is M2 - M1^2.
static Found found_raw(double t, Interval first, Interval second, int taps)
{
    double error = rounding_share(LOOKUP + (taps > 1 ? taps : 0));
    Interval m1 = t - first, m2 = second + 2 * t * m1 - t * t;
    double of_variance = error * (m2.hi + 2 * m1.hi * m1.hi) +
                         UNIT_ROUNDOFF * (m1.hi * m1.hi + m2.hi);
    Interval variance = widened(second - square(first), of_variance);
    return {widened(first, error * m1.hi + UNIT_ROUNDOFF),
            variance,
            {rounded(m1, error), rounded(m2, error)}};
}

// The deviation is right to a share of itself, see guard.h, the mean to a share
// of that and its own rounding.
static Found found_central(double t, Interval first, Interval second, int taps,
                           const Settings &settings)
{
    std::vector<MergePass> passes(3, {0, 0, 0, false, true});
    if (taps > 1)
        passes.push_back({taps + 1.0, 1.0 / taps, 0, false, false});
    CentralErrors e = central_errors(passes, settings);
    Interval variance = maximum(second - square(first), 0);
    double m1 = t - first.lo;
    double size = rounded_part(std::sqrt(m1 * m1 + variance.hi));
    double moved = e.moved * size + std::sqrt(e.tiny);
    double lo = std::max((1 - e.spread) * std::sqrt(variance.lo) - moved, 0.0);
    double hi = (1 + e.spread) * std::sqrt(variance.hi) + moved;
    double mean = e.mean * rounded_part(m1) + e.spread * std::sqrt(variance.hi);
    Interval before = widened(first, mean + UNIT_ROUNDOFF);
    Interval spread = {lo * lo, hi * hi};
    return {before, spread, {t - before, spread}};
}

// Of the mean of some lookups, less what is taken from the variance (or from
// M2, which is the same) but at most 9 tenths of it.
Bound SoftLookup::bound_at(const Receiver &r, const Before &exact,
                           Interval taken, int taps) const
{
    const Settings &settings = run_.settings;
    Found found =
        settings.central
            ? found_central(r.t, exact.first, exact.second, taps, settings)
            : found_raw(r.t, exact.first, exact.second, taps);
    if (taken.hi > 0) {
        Interval v = found.variance, whole = maximum(v, 0);
        taken = {std::min(taken.lo, 0.9 * whole.lo),
                 std::min(taken.hi, 0.9 * whole.hi)};
        found.variance = {std::max(v.lo - taken.hi, 0.1 * v.lo),
                          std::max(v.hi - taken.lo, 0.1 * v.hi)};
        // Two products and two differences: with numbers of the size of M2, or
        // of the variance itself.
        double size = settings.central ? v.hi : found.moments.second.hi;
        found.variance = widened(found.variance, rounding_share(4) * size);
        found.moments.second =
            rounded(found.moments.second - taken, rounding_share(4));
        if (settings.central)
            found.moments.second = found.variance;
    }
    const MapView &view = run_.views[size_t(r.layer)];
    return bound_of(found.moments, found.before, found.variance,
                    depth_noise(view, r.position), formula_);
}

// What one area says.
SoftLookup::Hidden SoftLookup::hidden(const Receiver &r, Interval area) const
{
    const Picture &map = levels_[size_t(r.layer)][0];
    Interval texels = maximum(area / 2.6, 1);
    PlaneSlopes slopes = plane_slopes(r, run_.views[size_t(r.layer)]);
    Interval plane =
        square(0.65 * texels) * (square(slopes.u / double(map.width)) +
                                 square(slopes.v / double(map.height)));
    Before seen = looked_up(r, r.u, r.v, 0, level_of(texels));
    Bound bound = bound_at(r, seen, rounded(plane, rounding_share(60)), 1);
    return {maximum(bound.before, 0), widened(1 - bound.p, UNIT_ROUNDOFF)};
}

SoftLookup::Disc SoftLookup::disc(const Receiver &r) const
{
    const MapView &view = run_.views[size_t(r.layer)];
    const Picture &map = levels_[size_t(r.layer)][0];
    const Settings &settings = run_.settings;
    double texels = shape_at(r, view, map).texels;
    double largest = LARGEST_PART * std::min(map.width, map.height);
    Interval here = distance_of(view, r.t);
    Interval widest =
        texels * width_of(view, settings, here, distance_of(view, 0));
    widest = clamp(rounded(widest, SHAPE_ERROR), 0, largest);
    widest = maximum(widest, LEAST_WIDTH);
    Interval middle{std::sqrt(LEAST_WIDTH * widest.lo),
                    std::sqrt(LEAST_WIDTH * widest.hi)};
    Hidden sum{0, 0};
    for (const Interval &area : {widest, rounded(middle, POWER_ERROR),
                                 rounded(Interval(LEAST_WIDTH), POWER_ERROR)}) {
        Hidden one = hidden(r, area);
        sum = {sum.before + one.before, sum.share + one.share};
    }
    sum = {rounded(sum.before, rounding_share(3)),
           rounded(sum.share, rounding_share(3))};
    Disc disc{
        sum.share.lo <= LEAST_HIDDEN, sum.share.hi > LEAST_HIDDEN, {}, {}};
    if (!disc.shaded)
        return disc;
    Interval gap = sum.before / maximum(sum.share, LEAST_HIDDEN);
    Interval z = maximum(r.t - rounded(gap, rounding_share(5)), 0);
    Interval occluder = distance_of(view, rounded(z, UNIT_ROUNDOFF));
    Interval width = settings.penumbra_scale * texels *
                     width_of(view, settings, here, occluder);
    width = rounded(width, SHAPE_ERROR);
    disc.width = {std::clamp(width.lo, LEAST_WIDTH, widest.lo),
                  std::clamp(width.hi, LEAST_WIDTH, widest.hi)};
    disc.compared = disc.width;
    if (disc.width.lo <= LEAST_WIDTH) {
        Interval half = rounded(0.5 * texels * (here - occluder), SHAPE_ERROR);
        disc.compared.lo = std::min(half.lo, LEAST_WIDTH);
        if (disc.width.hi <= LEAST_WIDTH)
            disc.compared.hi = std::min(half.hi, LEAST_WIDTH);
    }
    return disc;
}

// The mean over the taps, which go further out together when the disc grows.
Interval SoftLookup::bounded(const Receiver &r, const Disc &disc, int x,
                             int y) const
{
    const Picture &map = levels_[size_t(r.layer)][0];
    Shape shape = shape_at(r, run_.views[size_t(r.layer)], map);
    Interval level = level_of(TAP_RADIUS * disc.width);
    glm::dvec2 size(map.width, map.height);
    double middle = (disc.width.lo + disc.width.hi) / 4;
    double spread = disc.width.width() / 4 + SHAPE_ERROR * middle;
    Before sum{0, 0};
    for (const glm::dvec2 &tap : poisson_taps(x, y)) {
        glm::dvec2 out =
            (tap.x * shape.along + tap.y * shape.across) / shape.texels;
        glm::dvec2 uv = glm::dvec2(r.u, r.v) + middle * out / size;
        double error = spread * glm::length(out);
        if (error > std::exp2(level.lo)) // over a texel: nothing is known
            return {0, 1};
        Before one =
            looked_up(r, uv.x, uv.y, error / std::min(size.x, size.y), level);
        sum = {sum.first + one.first, sum.second + one.second};
    }
    double share = 1.0 / POISSON_TAPS;
    Before mean = {share * sum.first, share * sum.second};
    return reduced(bound_at(r, mean, 0, POISSON_TAPS).p, run_.settings);
}

// The receiver's plane at the texel's middle, less the bias of one texel,
// against the depth there.
static Interval compared_at(double t, const PlaneSlopes &slopes, Interval bias,
                            glm::dvec2 away, double depth)
{
    Interval step = slopes.u * away.x + slopes.v * away.y;
    double sizes = magnitude(slopes.u).hi * std::abs(away.x) +
                   magnitude(slopes.v).hi * std::abs(away.y);
    Interval moved = t + step - bias;
    moved = widened(moved, rounding_share(8) *
                               (std::abs(t) + magnitude(bias).hi + 2 * sizes));
    if (moved.hi <= depth)
        return 1;
    return moved.lo > depth ? Interval(0) : Interval(0, 1);
}

// --hybrid compares with step 1's default bias.
Interval SoftLookup::compared(const Receiver &r, const Disc &disc, int x,
                              int y) const
{
    const MapView &view = run_.views[size_t(r.layer)];
    const Picture &map = levels_[size_t(r.layer)][0];
    Settings settings = run_.settings;
    settings.bias = 5e-4;
    settings.slope_bias = 1;
    Interval bias = total_bias(r, view, map.width, map.height, 1, settings);
    PlaneSlopes slopes = plane_slopes(r, view);
    Shape shape = shape_at(r, view, map);
    glm::dvec2 size(map.width, map.height),
        middle = size * glm::dvec2(r.u, r.v);
    Interval lit = 0;
    for (const glm::dvec2 &tap : poisson_taps(x, y)) {
        glm::dvec2 out =
            (tap.x * shape.along + tap.y * shape.across) / shape.texels;
        double half = (disc.compared.lo + disc.compared.hi) / 4;
        double spread = disc.compared.width() / 4 + SHAPE_ERROR * half;
        glm::dvec2 place = middle + half * out;
        glm::dvec2 error = spread * glm::abs(out) + 4 * UNIT_ROUNDOFF * size;
        glm::dvec2 low =
            glm::clamp(glm::floor(place - error), glm::dvec2(0), size - 1.0);
        glm::dvec2 high =
            glm::clamp(glm::floor(place + error), glm::dvec2(0), size - 1.0);
        Interval here(1, 0);
        for (int j = int(low.y); j <= int(high.y); j++)
            for (int i = int(low.x); i <= int(high.x); i++) {
                glm::dvec2 away = (glm::dvec2(i, j) + 0.5 - middle) / size;
                Interval one = compared_at(r.t, slopes, bias, away,
                                           double(map.at(i, j, 0)));
                here = {std::min(here.lo, one.lo), std::max(here.hi, one.hi)};
            }
        lit = lit + here;
    }
    return lit / double(POISSON_TAPS);
}

Interval SoftLookup::visibility(const Receiver &r, int x, int y) const
{
    Disc here = disc(r);
    if (!here.shaded)
        return 1;
    Interval lit =
        run_.settings.hybrid ? compared(r, here, x, y) : bounded(r, here, x, y);
    return here.lit ? hull(lit, 1) : lit;
}
