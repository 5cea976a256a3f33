#include <cmath> // INFINITY

#include "tests/oracle/projection.h"
#include "tests/oracle/ray_checks.h"
#include "tests/oracle/ray_compare.h"
#include "tests/oracle/rounding.h"

void check_ray_positions(const Run &run, const Scene &scene,
                         const RayScene &rays, double extent, Report &report)
{
    PictureCamera camera(scene.camera, run.width, run.height);
    Receivers receivers(run);
    // The vertices' rounding and the blend of three, in world units.
    double rounding = rounding_share(32) * extent;
    RayComparison count;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            RayAt ray_at = [&](double dx, double dy) {
                return Ray{glm::dvec3(0),
                           camera.ray(x + 0.5 + dx, y + 0.5 + dy)};
            };
            Receiver r = receivers.at(x, y);
            // Along the ray, in units of depth, like the ray's own length.
            double value = r.shown ? camera.pixel_of(r.position).z : INFINITY;
            compare_with_rays(rays, ray_at, {value, INFINITY, rounding}, count);
        }
    bool passed =
        count.differs == 0 && count.silhouette_share() <= MOST_SILHOUETTE;
    report.line(passed, "positions against rays",
                "%zu of %zu pixels differ, worst of the others %.3g, "
                "rounding %.3g, at silhouettes %zu (%.3g %%)",
                count.differs, count.all(), count.worst, rounding,
                count.silhouette, 100 * count.silhouette_share());
}
