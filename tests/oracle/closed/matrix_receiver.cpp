#include <algorithm> // max
#include <cmath>     // abs

#include "tests/oracle/lib/interval.h"
#include "tests/oracle/closed/matrix.h"
#include "tests/oracle/lib/rounding.h"

// One row times (p, 1): each entry rounded to float, three products, three
// sums; 5 roundings on any one term.
static Interval product(const glm::dvec4 &row, const glm::dvec3 &p)
{
    double exact = row.w, size = std::abs(row.w);
    for (int i = 0; i < 3; i++) {
        exact += row[i] * p[i];
        size += std::abs(row[i] * p[i]);
    }
    return widened(exact, rounding_share(5) * size);
}

// A quotient, unless w is exactly 1; everything where w can be 0.
static Interval projected(const glm::dvec4 &row, const MapView &view,
                          const glm::dvec3 &p)
{
    if (view.parallel())
        return product(row, p);
    Interval w = product(view.rows[3], p);
    if (w.contains(0))
        return {-INFINITY, INFINITY};
    return rounded(product(row, p) / w, UNIT_ROUNDOFF);
}

// The light's position rounded, a difference, and the length of three such (4
// more), near and the factor rounded, a product and a sum.
Interval receiver_depth(const MapView &view, const glm::dvec3 &p)
{
    if (view.parallel())
        return product(view.rows[2], p);
    if (view.projected)
        return projected(view.rows[2], view, p);
    double range = view.far - view.near;
    double distance = glm::distance(p, view.position);
    double sizes = glm::length(p) + glm::length(view.position);
    double error = rounding_share(2) * sizes + rounding_share(7) * distance +
                   rounding_share(3) * view.near;
    return widened((distance - view.near) / range, error / range);
}

static bool agrees(double value, Interval expected, double &worst)
{
    if (std::isfinite(expected.width()))
        worst =
            std::max(worst, std::abs(value - (expected.lo + expected.hi) / 2));
    return expected.contains(value);
}

// How far the camera sees; the split's ends are rounded to float as well.
static Interval view_depth(const Run &run, const Receiver &r)
{
    Interval depth = product(run.clip_from_relative[3], r.position);
    return rounded(depth, UNIT_ROUNDOFF);
}

// The first split that reaches the depth, or the last one.
static bool right_split(const Run &run, const Receiver &r)
{
    Interval depth = view_depth(run, r);
    size_t layer = size_t(r.layer);
    bool reached = depth.lo <= run.views[layer].end;
    bool past = layer == 0 || depth.hi >= run.views[layer - 1].end;
    return past && (reached || layer + 1 == run.views.size());
}

// 3 s^2 - 2 s^3 between the depths where the hand-over begins and ends.
static bool right_handover(const Run &run, const Receiver &r)
{
    const MapView &view = run.views[size_t(r.layer)];
    double band = view.end - view.handover;
    // The ends of the band are rounded, and s is a quotient.
    Interval depth = view_depth(run, r) - view.handover;
    depth = widened(depth, 2 * UNIT_ROUNDOFF * view.end);
    Interval s = clamp(depth / band, 0, 1);
    auto smooth = [](double x) { return x * x * (3 - 2 * x); };
    Interval expected(smooth(s.lo), smooth(s.hi));
    return widened(expected, rounding_share(16)).contains(r.share);
}

// The layer of a point light is that of the view which looks most towards the
// point; two that differ by rounding only are both right.
static bool right_layer(const Run &run, const Receiver &r)
{
    const MapView &own = run.views[size_t(r.layer)];
    if (own.split())
        return right_split(run, r);
    if (own.lamp != Lamp::POINT)
        return r.layer == 0;
    Interval along = product(own.rows[3], r.position);
    for (const MapView &view : run.views)
        if (product(view.rows[3], r.position).lo > along.hi)
            return false;
    return true;
}

static bool right_place(const MapView &view, const Receiver &r, double &worst)
{
    const glm::dvec3 &p = r.position;
    bool right = agrees(r.u, projected(view.rows[0], view, p), worst);
    right &= agrees(r.v, projected(view.rows[1], view, p), worst);
    return right & agrees(r.t, receiver_depth(view, p), worst);
}

void check_receiver(const Run &run, Report &report)
{
    Receivers receivers(run);
    size_t wrong = 0, shown = 0, misplaced = 0, handed = 0, unfair = 0;
    double worst = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown)
                continue;
            const MapView &view = run.views[size_t(r.layer)];
            shown++;
            wrong += right_place(view, r, worst) ? 0 : 1;
            misplaced += right_layer(run, r) ? 0 : 1;
            if (!view.split())
                continue;
            handed += r.share > 0 ? 1 : 0;
            bool next = right_handover(run, r);
            if (r.share > 0 && size_t(r.layer) + 1 < run.views.size())
                next &= right_place(run.views[size_t(r.layer) + 1], r.in_next(),
                                    worst);
            unfair += next ? 0 : 1;
        }
    report.line(wrong == 0, "receiver = map_from_relative * position",
                "%zu of %zu pixels outside the rounding, worst %.3g", wrong,
                shown, worst);
    report.line(misplaced == 0, "each receiver is in its layer",
                "%zu of %zu pixels are in another", misplaced, shown);
    if (run.views.at(0).split())
        report.line(unfair == 0, "splits hand over",
                    "%zu of %zu pixels by a wrong share or place, %zu are "
                    "between two",
                    unfair, shown, handed);
}
