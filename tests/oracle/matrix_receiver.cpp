#include <algorithm> // max
#include <cmath>     // abs

#include "tests/oracle/interval.h"
#include "tests/oracle/matrix.h"
#include "tests/oracle/rounding.h"

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
static Interval depth(const MapView &view, const glm::dvec3 &p)
{
    if (view.parallel())
        return product(view.rows[2], p);
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

// The layer of a point light is that of the view which looks most towards the
// point; two that differ by rounding only are both right.
static bool right_layer(const Run &run, const Receiver &r)
{
    const MapView &own = run.views[size_t(r.layer)];
    if (own.lamp != Lamp::POINT)
        return r.layer == 0;
    Interval along = product(own.rows[3], r.position);
    for (const MapView &view : run.views)
        if (product(view.rows[3], r.position).lo > along.hi)
            return false;
    return true;
}

void check_receiver(const Run &run, Report &report)
{
    Receivers receivers(run);
    size_t wrong = 0, shown = 0, misplaced = 0;
    double worst = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown)
                continue;
            const MapView &view = run.views[size_t(r.layer)];
            const glm::dvec3 &p = r.position;
            bool right = agrees(r.u, projected(view.rows[0], view, p), worst);
            right &= agrees(r.v, projected(view.rows[1], view, p), worst);
            right &= agrees(r.t, depth(view, p), worst);
            shown++;
            wrong += right ? 0 : 1;
            misplaced += right_layer(run, r) ? 0 : 1;
        }
    report.line(wrong == 0, "receiver = map_from_relative * position",
                "%zu of %zu pixels outside the rounding, worst %.3g", wrong,
                shown, worst);
    report.line(misplaced == 0, "each receiver is in its layer",
                "%zu of %zu pixels are in another", misplaced, shown);
}
