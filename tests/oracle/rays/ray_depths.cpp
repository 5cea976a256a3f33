#include <algorithm> // max

#include "tests/oracle/filters/chebyshev_bound.h" // store_share
#include "tests/oracle/dump/light.h"              // depth_size
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/rays/ray_checks.h"
#include "tests/oracle/rays/ray_compare.h"
#include "tests/oracle/lib/rounding.h"

Ray map_ray(const MapView &view, double u, double v, double start)
{
    glm::dvec3 along =
        point_of_map(view, {u, v, 1}) - point_of_map(view, {u, v, 0});
    return {point_of_map(view, {u, v, start}), along};
}

bool before_near(const MapView &view, const RayScene &rays, const Ray &ray,
                 double start)
{
    if (!view.parallel())
        return false;
    glm::dvec3 at_near = ray.origin - start * ray.direction;
    return rays.occluded({at_near, -ray.direction});
}

// What is before a parallel light's near plane is in its map at depth 0. False:
// nothing is there, and the texel has to be compared.
static bool count_clamped(const MapView &view, const RayScene &rays,
                          const RayAt &ray_at, double start, double value,
                          RayComparison &count)
{
    bool before = before_near(view, rays, ray_at(0, 0), start);
    if (before == (value == 0)) {
        count.agrees += before ? 1 : 0;
        return before;
    }
    bool mixed = false; // an outline within SUBPIXEL
    for (double dy : {-SUBPIXEL, SUBPIXEL})
        for (double dx : {-SUBPIXEL, SUBPIXEL})
            mixed |= before_near(view, rays, ray_at(dx, dy), start) != before;
    if (mixed)
        count.silhouette++;
    else
        count.differs++;
    return true;
}

// What the texel says as a depth along its ray, which is linear.
static Measured measured_texel(const Run &run, const MapView &view, int x,
                               int y, double stored, double extent)
{
    double u = (x + 0.5) / view.width, v = (y + 0.5) / view.height;
    double rounding = rounding_share(16) * depth_size(view, extent, stored) +
                      store_share(run.settings); // depths are at most 1
    // The stored depth is a concave function of the distance: a step away from
    // the light is the longer one.
    double value = linear_depth(view, u, v, stored);
    double beyond = linear_depth(view, u, v, stored + rounding);
    return {value, linear_depth(view, u, v, 1), beyond - value};
}

// The depth test of a perspective view compares z / w = far / (far - near) (1 -
// near / w) in 24 bits, and so cannot tell surfaces apart that are nearer to
// each other than this part of the range, at distance w.
static double depth_test_step(const MapView &view, double stored)
{
    if (view.parallel())
        return 0;
    double w = view.projected ? distance_along_axis(view, stored)
                              : view.near + stored * (view.far - view.near);
    return 4 * UNIT_ROUNDOFF * w * w / (view.near * view.far);
}

RayComparison compare_ray_depths(const Run &run, const RayScene &rays,
                                 double extent, int layer, DepthTest test,
                                 double &worst_rounding)
{
    const MapView &view = run.views[size_t(layer)];
    Picture map = load_map(run, layer);
    // The vertices' rounding, the blend of three, and the depth's formula.
    double rounding = rounding_share(16) * depth_size(view, extent);
    // A surface may lie exactly in the near plane: start a little before it.
    double start = -std::max(rounding, 1e-6);
    RayComparison count;
    for (int y = 0; y < map.height; y++)
        for (int x = 0; x < map.width; x++) {
            RayAt ray_at = [&](double dx, double dy) {
                return map_ray(view, (x + 0.5 + dx) / map.width,
                               (y + 0.5 + dy) / map.height, start);
            };
            if (view.parallel() &&
                count_clamped(view, rays, ray_at, start, map.at(x, y), count))
                continue;
            Measured measured =
                measured_texel(run, view, x, y, map.at(x, y), extent);
            if (test == DepthTest::ROUNDED)
                measured.rounding += depth_test_step(view, map.at(x, y));
            worst_rounding = std::max(worst_rounding, measured.rounding);
            measured.value -= start;
            measured.empty -= start;
            compare_with_rays(rays, ray_at, measured, count);
        }
    return count;
}

void check_ray_depths(const Run &run, const RayScene &rays, double extent,
                      int layer, Report &report)
{
    double worst_rounding = 0;
    RayComparison count = compare_ray_depths(run, rays, extent, layer,
                                             DepthTest::EXACT, worst_rounding);
    bool passed =
        count.differs == 0 && count.silhouette_share() <= MOST_SILHOUETTE;
    report.line(passed, "map depths against rays",
                "%zu of %zu texels differ, worst of the others %.3g, "
                "rounding %.3g, at silhouettes %zu (%.3g %%)",
                count.differs, count.all(), count.worst, worst_rounding,
                count.silhouette, 100 * count.silhouette_share());
}
