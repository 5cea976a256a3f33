#include "tests/oracle/rays/ray_compare.h"

#include <algorithm> // max
#include <cmath>     // abs, isfinite
#include <vector>

#include "tests/oracle/lib/rounding.h"

namespace
{

// A surface on a ray, and how far a rasterised distance to it may be off.
struct Surface {
    double distance, tolerance;

    bool agrees(double value) const
    {
        // Written so that two infinities agree and NaN does not.
        return value == distance || std::abs(value - distance) <= tolerance;
    }
};

} // namespace

// How much the distance to this plane changes when the ray moves by SUBPIXEL
// along both axes. 0 for a plane seen edge on: it has no such distance.
static double slope(const RayAt &ray_at, double dx, double dy,
                    const Triangle &triangle, double centre)
{
    double most = 0;
    for (double y : {-SUBPIXEL, SUBPIXEL})
        for (double x : {-SUBPIXEL, SUBPIXEL}) {
            Ray ray = ray_at(dx + x, dy + y);
            double moved = plane_distance(ray, triangle);
            most = std::max(most, std::abs(moved - centre));
        }
    return std::isfinite(most) ? most : 0;
}

// The first surface at `start` or more along the moved ray; what is beyond the
// empty distance counts as empty.
static Surface next_surface(const RayScene &rays, const RayAt &ray_at,
                            double dx, double dy, double start,
                            const Measured &measured)
{
    Hit hit = rays.first(ray_at(dx, dy), start);
    if (!hit.found() || hit.distance >= measured.empty)
        return {measured.empty, measured.rounding};
    double moved =
        slope(ray_at, dx, dy, rays.triangle(hit.triangle), hit.distance);
    return {hit.distance, measured.rounding + moved};
}

// All surfaces along the moved ray, and the empty distance last. Surfaces
// closer to each other than the rounding count as one.
static std::vector<Surface> surfaces(const RayScene &rays, const RayAt &ray_at,
                                     double dx, double dy,
                                     const Measured &measured)
{
    std::vector<Surface> found;
    double start = 0;
    for (int i = 0; i < 64; i++) {
        found.push_back(next_surface(rays, ray_at, dx, dy, start, measured));
        if (found.back().distance >= measured.empty)
            break;
        start = found.back().distance + 2 * measured.rounding;
    }
    return found;
}

using Bundle = std::vector<std::vector<Surface>>;

// Whether some ray of the bundle passes by this surface.
static bool can_be_missed(const Bundle &bundle, const Surface &surface)
{
    for (const auto &ray : bundle) {
        bool met = false;
        for (const Surface &other : ray)
            met = met || surface.agrees(other.distance) ||
                  other.agrees(surface.distance);
        if (!met)
            return true;
    }
    return false;
}

// The value is that of a surface within SUBPIXEL of the centre, and each
// surface in front of it has its outline there too.
static bool at_silhouette(const RayScene &rays, const RayAt &ray_at,
                          const Measured &measured)
{
    Bundle bundle;
    for (double dy : {-SUBPIXEL, 0.0, SUBPIXEL})
        for (double dx : {-SUBPIXEL, 0.0, SUBPIXEL})
            bundle.push_back(surfaces(rays, ray_at, dx, dy, measured));
    for (const auto &ray : bundle)
        for (const Surface &surface : ray) {
            if (surface.agrees(measured.value))
                return true;
            if (!can_be_missed(bundle, surface))
                break;
        }
    return false;
}

void RayComparison::add(double found, double most)
{
    worst = std::max(worst, found);
    if (found <= largest_share * most)
        return;
    largest_share = found / most;
    error = found;
    allowed = most;
}

Verdict compare_with_rays(const RayScene &rays, const RayAt &ray_at,
                          const Measured &measured, RayComparison &count)
{
    Surface centre = next_surface(rays, ray_at, 0, 0, 0, measured);
    if (centre.agrees(measured.value)) {
        count.agrees++;
        if (measured.value != centre.distance) // also not two infinities
            count.add(std::abs(measured.value - centre.distance),
                      centre.tolerance);
        return Verdict::AGREES;
    }
    if (at_silhouette(rays, ray_at, measured)) {
        count.silhouette++;
        return Verdict::SILHOUETTE;
    }
    count.differs++;
    return Verdict::DIFFERS;
}
