#include <algorithm> // any_of, clamp, min
#include <cmath>     // INFINITY

#include "tests/oracle/dump/projection.h"
#include "tests/oracle/rays/ray_checks.h"
#include "tests/oracle/rays/ray_compare.h"
#include "tests/oracle/lib/rounding.h"

// Of a point from the line between two others, in a picture.
static double distance_to(const glm::dvec2 &a, const glm::dvec2 &b,
                          const glm::dvec2 &point)
{
    glm::dvec2 along = b - a;
    double square = glm::dot(along, along);
    double part = square > 0 ? glm::dot(point - a, along) / square : 0;
    return glm::length(a + std::clamp(part, 0.0, 1.0) * along - point);
}

// Whether the pixel's centre is next to a triangle that is seen edge on. The
// rasteriser moves each corner by up to sqrt(2) / 512 pixel: a triangle less
// than twice that wide may show either side and cover the centres within
// SUBPIXEL of its sides, with whatever positions its plane has there.
static bool beside_edge_on(const PictureCamera &camera, const Triangle &t,
                           const glm::dvec2 &centre)
{
    glm::dvec3 p[3] = {camera.pixel_of(t.a), camera.pixel_of(t.b),
                       camera.pixel_of(t.c)};
    double longest = 0, nearest = INFINITY;
    for (int k = 0; k < 3; k++) {
        if (p[k].z <= 0)
            return false;
        glm::dvec2 a(p[k]), b(p[(k + 1) % 3]);
        longest = std::max(longest, glm::length(b - a));
        nearest = std::min(nearest, distance_to(a, b, centre));
    }
    glm::dvec2 u = p[1] - p[0], v = p[2] - p[0];
    double twice_area = std::abs(u.x * v.y - u.y * v.x);
    return nearest <= SUBPIXEL && twice_area <= 2 * SUBPIXEL * longest;
}

static bool beside_any(const RayScene &rays, const PictureCamera &camera, int x,
                       int y)
{
    const std::vector<Triangle> &all = rays.triangles();
    return std::any_of(all.begin(), all.end(), [&](const Triangle &triangle) {
        return beside_edge_on(camera, triangle, {x + 0.5, y + 0.5});
    });
}

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
            RayComparison one;
            Verdict verdict = compare_with_rays(
                rays, ray_at, {value, INFINITY, rounding}, one);
            if (verdict == Verdict::DIFFERS && beside_any(rays, camera, x, y)) {
                one = {};
                one.silhouette = 1;
            }
            count.add(one);
        }
    bool passed =
        count.differs == 0 && count.silhouette_share() <= MOST_SILHOUETTE;
    report.line(passed, "positions against rays",
                "%zu of %zu pixels differ, worst of the others %.3g, "
                "rounding %.3g, at silhouettes %zu (%.3g %%)",
                count.differs, count.all(), count.worst, rounding,
                count.silhouette, 100 * count.silhouette_share());
}
