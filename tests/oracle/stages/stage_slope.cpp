#include <algorithm> // max, min
#include <array>
#include <cmath> // abs, isfinite

#include "tests/oracle/filters/chebyshev_bound.h" // store_share
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/dump/light.h" // depth_size
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/rays/ray_checks.h" // map_ray
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/stages/stage.h"

namespace
{

// The plane of a triangle as the map sees it.
struct MapTriangle {
    const Run &run;
    const MapView &view;
    Triangle triangle;

    // The stored depth at a place in texels.
    double at(double x, double y) const
    {
        double u = x / view.width, v = y / view.height;
        Ray ray = map_ray(view, u, v, 0);
        return stored_depth(view, u, v, plane_distance(ray, triangle));
    }
};

struct Slopes {
    Interval across, up; // depth per texel
};

} // namespace

// The derivative, in double: the formula is smooth, so that the error of the
// step is its square times the third derivative, and far below 32 bits.
static Slopes slopes_at(const MapTriangle &surface, double x, double y)
{
    double step = 1e-3;
    return {(surface.at(x + step, y) - surface.at(x - step, y)) / (2 * step),
            (surface.at(x, y + step) - surface.at(x, y - step)) / (2 * step)};
}

// The corners of a triangle are floats, and each may be off by `error`: the
// plane turns by up to that over the triangle's height. It is the slopes'
// largest change when one corner moves along the normal.
static Slopes plane_slopes(const MapTriangle &surface, double x, double y,
                           double error)
{
    Slopes exact = slopes_at(surface, x, y), all = exact;
    glm::dvec3 away = error * glm::normalize(surface.triangle.normal());
    for (int corner = 0; corner < 3; corner++) {
        MapTriangle moved = surface;
        Triangle &t = moved.triangle;
        (corner == 0 ? t.a : corner == 1 ? t.b : t.c) += away;
        Slopes other = slopes_at(moved, x, y);
        double across = std::abs(other.across.lo - exact.across.lo);
        double up = std::abs(other.up.lo - exact.up.lo);
        all = {widened(all.across, across), widened(all.up, up)};
    }
    // Two matrix rows, cross and dot products, a square root and a quotient.
    return {rounded(all.across, rounding_share(64)),
            rounded(all.up, rounding_share(64))};
}

// With --msaa a fragment has its position anywhere in the texel that it covers,
// which need not be the middle although the triangle covers all: clipping may
// have cut it in two. Between these 3 x 3 places a slope is as good as linear;
// what bends counts twice.
static Slopes texel_slopes(const MapTriangle &surface, int x, int y,
                           double error)
{
    Slopes all = plane_slopes(surface, x + 0.5, y + 0.5, error);
    Slopes middle = all;
    for (double dy : {0.0, 0.5, 1.0})
        for (double dx : {0.0, 0.5, 1.0}) {
            Slopes there = plane_slopes(surface, x + dx, y + dy, error);
            all = {hull(all.across, there.across), hull(all.up, there.up)};
        }
    auto bend = [](const Interval &whole, const Interval &centre) {
        return std::abs((whole.lo + whole.hi) - (centre.lo + centre.hi));
    };
    return {widened(all.across, bend(all.across, middle.across)),
            widened(all.up, bend(all.up, middle.up))};
}

// Differences in the block of 2 x 2 fragments: in one row (or column) of it.
static Slopes derivative_slopes(const MapTriangle &surface, int x, int y,
                                double rounding)
{
    double left = x / 2 * 2 + 0.5, low = y / 2 * 2 + 0.5;
    auto depth = [&](int i, int j) { return surface.at(left + i, low + j); };
    Slopes all = {hull(depth(1, 0) - depth(0, 0), depth(1, 1) - depth(0, 1)),
                  hull(depth(0, 1) - depth(0, 0), depth(1, 1) - depth(1, 0))};
    return {widened(all.across, 2 * rounding), widened(all.up, 2 * rounding)};
}

// Whether the rays around a place in the map all meet the one triangle. Here
// the rasteriser has no choice, and there is an own plane.
static int triangle_at(const MapView &view, const RayScene &rays, double x,
                       double y, double reach)
{
    int found = -2;
    for (double dy : {-reach, 0.0, reach})
        for (double dx : {-reach, 0.0, reach}) {
            Ray ray = map_ray(view, (x + dx) / view.width,
                              (y + dy) / view.height, -1e-6);
            int hit = rays.first(ray).triangle;
            if (found == -2)
                found = hit;
            if (hit != found)
                return -1;
        }
    return found;
}

// One depth per texel.
static void check_slopes(const Run &run, const RayScene &rays, double extent,
                         const MapView &view, const Picture &map,
                         Report &report)
{
    const Settings &settings = run.settings;
    size_t tested = 0, wrong = 0, sloped = 0, covered = 0;
    double worst = 0;
    for (int y = 0; y < map.height; y++)
        for (int x = 0; x < map.width; x++) {
            float m1 = map.at(x, y, 0), m2 = map.at(x, y, 1);
            if (!(m1 > 0 && m1 < 1)) {
                wrong += m2 == (settings.central ? 0 : m1) ? 0 : 1;
                continue;
            }
            covered++;
            // A block of 2 x 2 reaches 1 texel further, samples half a one.
            double reach = settings.slope_derivatives ? 1
                           : settings.msaa > 1        ? 0.5 + 4 * SUBPIXEL
                                                      : 4 * SUBPIXEL;
            int hit = triangle_at(view, rays, x + 0.5, y + 0.5, reach);
            if (hit < 0)
                continue;
            MapTriangle surface{run, view, rays.triangle(hit)};
            double rounding = rounding_share(16) * depth_size(view, extent, m1);
            double corners = rounding_share(6) * 3 * extent;
            Slopes slopes =
                settings.slope_derivatives
                    ? derivative_slopes(surface, x, y, rounding)
                : settings.msaa > 1
                    ? texel_slopes(surface, x, y, corners)
                    : plane_slopes(surface, x + 0.5, y + 0.5, corners);
            Interval term = 0.25 * (square(slopes.across) + square(slopes.up));
            Interval depth = rounded(m1, store_share(settings));
            Interval truth = square(depth) + term;
            truth = {std::min(truth.lo, depth.lo),
                     std::min(truth.hi, depth.hi)};
            if (settings.central) { // the same, less the square
                Interval most = depth - square(depth);
                truth = {std::min(term.lo, most.lo),
                         std::min(term.hi, most.hi)};
                truth = widened(truth, truth.hi > most.lo ? UNIT_ROUNDOFF : 0);
            }
            truth = rounded(truth, store_share(settings) + rounding_share(6));
            truth = widened(truth, store_absolute(settings));
            if (!std::isfinite(truth.width()) || truth.width() > 1e-2)
                continue;
            tested++;
            sloped += term.lo > truth.width() ? 1 : 0;
            wrong += truth.contains(m2) ? 0 : 1;
            worst = std::max(worst, truth.distance(m2));
        }
    report.line(wrong == 0 && 2 * tested >= covered,
                "stage slope: the second channel is that of a sloping texel",
                "%zu of %zu tested texels off, worst by %.3g; %zu covered, on "
                "%zu the slope is more than the rounding",
                wrong, tested, worst, covered, sloped);
}

void check_slope(const Run &run, const RayScene &rays, double extent, int layer,
                 Report &report)
{
    for (const Picture &sample : load_samples(run, layer))
        check_slopes(run, rays, extent, run.views[size_t(layer)], sample,
                     report);
}
