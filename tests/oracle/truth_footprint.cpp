#include <algorithm> // max
#include <cmath>     // INFINITY
#include <memory>    // shared_ptr

#include "tests/oracle/axis_kernel.h"
#include "tests/oracle/own_plane.h"
#include "tests/oracle/projection.h"
#include "tests/oracle/strata.h"
#include "tests/oracle/truth.h"

namespace
{

// The kernel's points, in map texels from the receiver.
struct Points {
    Strata strata;
    double half_width;

    Points(double rays, const Run &run) : strata(rays)
    {
        AxisKernel kernel(run.step, run.settings);
        half_width = kernel.half_width();
        for (Pattern &pattern : strata.all())
            for (glm::dvec2 &point : pattern)
                point = {kernel.quantile(point.x), kernel.quantile(point.y)};
    }
};

// The receiver's plane, in map texels from the receiver.
struct Patch {
    OwnPlane plane;
    glm::dvec2 centre, texel; // u and v

    Patch(const MapView &view, const Surface &surface)
        : plane(view, surface.point, surface.normal),
          centre(map_point(view, surface.point)),
          texel(1.0 / view.width, 1.0 / view.height)
    {
    }

    bool point(const glm::dvec2 &texels, glm::dvec3 &found) const
    {
        glm::dvec2 uv = centre + texels * texel;
        return plane.meets(uv.x, uv.y, found);
    }

    // The farthest of the points up to half_width texels away: a perspective
    // keeps lines straight, so one of the corners, unless the light does not
    // see the plane there.
    double reach(const glm::dvec3 &from, double half_width) const
    {
        double farthest = 0;
        for (double y : {-half_width, half_width})
            for (double x : {-half_width, half_width}) {
                glm::dvec3 corner;
                if (!point({x, y}, corner))
                    return INFINITY;
                farthest = std::max(farthest, glm::distance(from, corner));
            }
        return farthest;
    }
};

} // namespace

// The points that the receiver cannot see along its own plane lie inside other
// geometry or behind it, and those that are not on the plane, as the light sees
// it, are nowhere: both are left out.
static TruthValue average(const TruthScene &scene, const Points &points,
                          const Pixel &pixel, const MapView &view)
{
    const Surface &surface = pixel.surface;
    Patch patch(view, surface);
    glm::dvec3 start = scene.lifted(surface), off = start - surface.point;
    double reach = patch.reach(surface.point, points.half_width);
    bool obstacles = std::isinf(reach) ||
                     scene.rays.crosses_plane(start, surface.normal, reach);
    const Pattern &pattern = points.strata.at(pixel.x, pixel.y);
    size_t left = 0, lit = 0;
    for (const glm::dvec2 &texels : pattern) {
        glm::dvec3 point;
        if (!patch.point(texels, point))
            continue;
        if (obstacles && scene.rays.occluded({start, point - surface.point}, 1))
            continue;
        left++;
        lit += scene.lit(view, point + off) ? 1 : 0;
    }
    double share = left > 0 ? double(lit) / double(left) : 0;
    return {share, 2 * left < pattern.size()};
}

Truth footprint_truth(const TruthScene &scene, double rays)
{
    auto points = std::make_shared<Points>(rays, scene.run);
    auto at = [&scene, points](const Pixel &pixel,
                               const Receiver &r) -> TruthValue {
        if (!pixel.surface.found)
            return {1, true};
        return average(scene, *points, pixel, scene.view(r));
    };
    return {"footprint", [&scene, at](const Pixel &pixel) {
                return over_layers(scene, pixel, at);
            }};
}
