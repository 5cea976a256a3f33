#include <algorithm> // find, max, min
#include <cmath>     // abs, isfinite
#include <vector>

#include "tests/oracle/filters/chebyshev_bound.h" // store_share
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/dump/light.h" // depth_size
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/rays/ray_checks.h"
#include "tests/oracle/rays/ray_compare.h" // MOST_SILHOUETTE
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/rays/texel_depths.h"

namespace
{

struct SampleMap {
    const Run &run;
    const MapView &view;
    const RayScene &rays;
    double extent;
    double start; // of a ray; see check_ray_depths

    Ray ray_at(const glm::dvec2 &texels) const
    {
        return map_ray(view, texels.x / view.width, texels.y / view.height,
                       start);
    }
};

// What is on a ray, from the light on: triangles, and NOTHING behind them.
using Surfaces = std::vector<int>;
constexpr int NOTHING = -1; // as a Hit has it

struct Tally {
    size_t all = 0, outline = 0, wrong = 0;
    double worst = 0; // distance from what it may be
};

} // namespace

// The triangles on a ray, up to a distance. Of those that are closer to each
// other than the rounding one counts.
static void add_triangles(const SampleMap &map, const Ray &ray, double end,
                          Surfaces &surfaces)
{
    double from = 0;
    for (int i = 0; i < 64; i++) {
        Hit hit = map.rays.first(ray, from);
        if (!hit.found() || hit.distance > end)
            return;
        surfaces.push_back(hit.triangle);
        from = hit.distance - 2 * map.start;
    }
}

// Only the near plane of a split has something before it, which is all at depth
// 0: whatever is drawn first stays.
static Surfaces surfaces_at(const SampleMap &map, const glm::dvec2 &texels)
{
    Surfaces surfaces;
    Ray ray = map.ray_at(texels);
    if (before_near(map.view, map.rays, ray, map.start)) {
        glm::dvec3 near = ray.origin - map.start * ray.direction;
        add_triangles(map, {near, -ray.direction}, INFINITY, surfaces);
        return surfaces;
    }
    add_triangles(map, ray, 1 - map.start, surfaces);
    surfaces.push_back(NOTHING);
    return surfaces;
}

// The same where one is enough.
static int first_surface(const SampleMap &map, const glm::dvec2 &texels)
{
    return map.view.split() ? surfaces_at(map, texels).front()
                            : map.rays.first(map.ray_at(texels)).triangle;
}

// How much the depth on a triangle's plane changes over SUBPIXEL along both
// axes: a rasteriser moves the triangle so far, and may interpolate on the
// plane of the one that it did not move.
static double moves(const SampleMap &map, const glm::dvec2 &texels,
                    const Triangle &triangle)
{
    double here = plane_distance(map.ray_at(texels), triangle), most = 0;
    for (double dy : {-SUBPIXEL, SUBPIXEL})
        for (double dx : {-SUBPIXEL, SUBPIXEL}) {
            Ray ray = map.ray_at(texels + glm::dvec2(dx, dy));
            most =
                std::max(most, std::abs(plane_distance(ray, triangle) - here));
        }
    // z / w is steeper than the distance by far / near at most.
    double steeper = map.view.projected ? map.view.far / map.view.near : 1;
    return std::isfinite(most) ? steeper * most : 0;
}

// How far the value is from the depths that a surface has in the texel x, y.
static double distance_from(const SampleMap &map, int surface,
                            const glm::dvec2 &texels, int x, int y,
                            double value)
{
    Interval depths(1);
    double moved = 0;
    if (surface != NOTHING) {
        const Triangle &triangle = map.rays.triangle(surface);
        if (!depths_in_texel(map.view, triangle, x, y, depths))
            return INFINITY;
        moved = moves(map, texels, triangle);
    }
    double rounding =
        rounding_share(16) * depth_size(map.view, map.extent, depths.hi) +
        store_share(map.run.settings) + store_absolute(map.run.settings);
    return widened(depths, moved + rounding).distance(value);
}

// The rays around a place, as far as a rasteriser may move a triangle.
using Bundle = std::vector<std::pair<glm::dvec2, Surfaces>>;

static Bundle bundle_at(const SampleMap &map, const glm::dvec2 &texels)
{
    Bundle bundle;
    for (double dy : {-SUBPIXEL, 0.0, SUBPIXEL})
        for (double dx : {-SUBPIXEL, 0.0, SUBPIXEL}) {
            glm::dvec2 near = texels + glm::dvec2(dx, dy);
            bundle.emplace_back(near, surfaces_at(map, near));
        }
    return bundle;
}

// How many rays of the bundle meet a surface.
static size_t rays_on(const Bundle &bundle, int surface)
{
    size_t count = 0;
    for (const auto &[place, surfaces] : bundle)
        count += std::find(surfaces.begin(), surfaces.end(), surface) !=
                         surfaces.end()
                     ? 1
                     : 0;
    return count;
}

// The same of what a rasteriser may see at a place: what the bundle meets
// behind surfaces that part of it misses, and slivers between its rays.
static double distance_at_outline(const SampleMap &map,
                                  const glm::dvec2 &texels, int x, int y,
                                  double value)
{
    Bundle bundle = bundle_at(map, texels);
    double least = INFINITY;
    for (const auto &[place, surfaces] : bundle)
        for (int surface : surfaces) {
            least = std::min(least,
                             distance_from(map, surface, place, x, y, value));
            if (rays_on(bundle, surface) == bundle.size())
                break;
        }
    int count = int(map.rays.triangles().size());
    for (int i = 0; least > 0 && i < count; i++)
        if (overlaps(map.view, map.rays.triangle(i), texels, SUBPIXEL) &&
            rays_on(bundle, i) == 0)
            least = std::min(least, distance_from(map, i, texels, x, y, value));
    return least;
}

static void check_sample(const SampleMap &map, const glm::dvec2 &place, int x,
                         int y, double value, Tally &tally)
{
    glm::dvec2 texels = glm::dvec2(x, y) + place;
    tally.all++;
    int first = first_surface(map, texels);
    if (distance_from(map, first, texels, x, y, value) == 0)
        return;
    double distance = distance_at_outline(map, texels, x, y, value);
    tally.outline += distance == 0 ? 1 : 0;
    tally.wrong += distance == 0 ? 0 : 1;
    tally.worst = std::max(tally.worst, distance);
}

void check_sample_depths(const Run &run, const RayScene &rays, double extent,
                         int layer, Report &report)
{
    const MapView &view = run.views[size_t(layer)];
    double rounding = rounding_share(16) * depth_size(view, extent);
    SampleMap map{run, view, rays, extent, -std::max(rounding, 1e-6)};
    std::vector<Picture> samples = load_samples(run, layer);
    Tally tally;
    for (size_t i = 0; i < samples.size(); i++)
        for (int y = 0; y < view.height; y++)
            for (int x = 0; x < view.width; x++)
                check_sample(map, run.places[i], x, y,
                             double(samples[i].at(x, y)), tally);
    double share = double(tally.outline) / double(tally.all);
    report.line(tally.wrong == 0 && share <= MOST_SILHOUETTE,
                "samples: depths of what covers them",
                "%zu of %zu samples are none in their texel, worst by %.3g, "
                "at silhouettes %zu (%.3g %%)",
                tally.wrong, tally.all, tally.worst, tally.outline,
                100 * share);
}
