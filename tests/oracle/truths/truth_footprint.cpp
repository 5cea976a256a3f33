#include <algorithm> // max
#include <cmath>     // INFINITY
#include <map>
#include <memory> // shared_ptr

#include "tests/oracle/filters/axis_kernel.h"
#include "tests/oracle/rays/own_plane.h"
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/lib/strata.h"
#include "tests/oracle/truths/truth.h"

namespace
{

// Steps that spread whole multiples of them evenly over the unit square: one
// over the plastic number, and over its square.
const glm::dvec2 PLASTIC(0.7548776662466927, 0.5698402909980532);

// The kernel's points, in map texels from the receiver.
struct Points {
    Strata strata;
    double half_width;

    Points(double rays, int step, const Settings &settings) : strata(rays)
    {
        if (settings.poisson)
            fill_disc(settings.kernel);
        else
            fill_square(AxisKernel(step, settings));
    }

  private:
    // The texel that a tap falls into is as good as a point of it: the disc,
    // spread over a box of one texel by a second pair of strata.
    void fill_disc(int width)
    {
        half_width = (width + 1) / 2.0;
        for (Pattern &pattern : strata.all())
            for (size_t i = 0; i < pattern.size(); i++) {
                glm::dvec2 within = glm::fract(double(i) * PLASTIC) - 0.5;
                pattern[i] = 0.5 * width * disc_point(pattern[i]) + within;
            }
    }

    void fill_square(const AxisKernel &kernel)
    {
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
    // By the width that the pixel has chosen, where it may.
    auto points = std::make_shared<std::map<int, Points>>();
    Settings settings = scene.run.settings;
    for (int width = settings.adaptive ? 1 : settings.kernel;
         width <= scene.run.settings.kernel; width += 2) {
        settings.kernel = width;
        points->emplace(width, Points(rays, scene.run.step, settings));
    }
    auto at = [&scene, points](const Pixel &pixel,
                               const Receiver &r) -> TruthValue {
        if (!pixel.surface.found)
            return {1, true};
        const MapView &view = scene.view(r);
        int width =
            scene.widths.at(r, pixel.x, pixel.y, view.width, view.height)
                .front();
        return average(scene, points->at(width), pixel, view);
    };
    return {"footprint", [&scene, at](const Pixel &pixel) {
                return over_layers(scene, pixel, at);
            }};
}
