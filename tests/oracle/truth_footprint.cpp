#include <memory> // shared_ptr

#include "tests/oracle/axis_kernel.h"
#include "tests/oracle/light.h" // inside_map
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

// How a step of one texel moves along the receiver's plane, in relative space.
struct TexelSteps {
    glm::dvec3 across, up;

    TexelSteps(const MapView &view, const MapPlane &plane)
    {
        glm::dvec3 zero = point_of_map(view, {0, 0, 0});
        glm::dvec3 u = point_of_map(view, {1, 0, plane.per_u}) - zero;
        glm::dvec3 v = point_of_map(view, {0, 1, plane.per_v}) - zero;
        across = u / double(view.width);
        up = v / double(view.height);
    }
};

} // namespace

// The points that the receiver cannot see along its own plane lie inside other
// geometry or behind it: they are left out.
static TruthValue average(const TruthScene &scene, const Points &points,
                          const Pixel &pixel)
{
    const Surface &surface = pixel.surface;
    const MapView &view = scene.view(pixel.receiver);
    TexelSteps steps(view, surface.plane);
    glm::dvec3 start = surface.point + scene.lift * surface.normal;
    glm::dvec3 light = to_light(view);
    double reach =
        points.half_width * (glm::length(steps.across) + glm::length(steps.up));
    bool obstacles = scene.rays.crosses_plane(start, surface.normal, reach);
    const Pattern &pattern = points.strata.at(pixel.x, pixel.y);
    size_t left = 0, lit = 0;
    for (const glm::dvec2 &point : pattern) {
        glm::dvec3 offset = point.x * steps.across + point.y * steps.up;
        if (obstacles && scene.rays.occluded({start, offset}, 1))
            continue;
        left++;
        lit += scene.lit(start + offset, light) ? 1 : 0;
    }
    double share = left > 0 ? double(lit) / double(left) : 0;
    return {share, 2 * left < pattern.size()};
}

Truth footprint_truth(const TruthScene &scene, double rays)
{
    auto points = std::make_shared<Points>(rays, scene.run);
    auto at = [&scene, points](const Pixel &pixel) -> TruthValue {
        if (!inside_map(pixel.receiver))
            return {1};
        if (!pixel.surface.found)
            return {1, true};
        return average(scene, *points, pixel);
    };
    return {"footprint", at};
}
