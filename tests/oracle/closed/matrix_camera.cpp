#include <algorithm> // max
#include <cfloat>    // DBL_EPSILON
#include <cmath>     // abs

#include "tests/oracle/closed/matrix.h"
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/lib/rounding.h"

// Rows x, y and w of the program's clip_from_relative against GLM's; row z
// depends on a near and a far that are the program's own business.
static void check_rows(const Run &run, const PictureCamera &camera,
                       Report &report)
{
    glm::dmat4 rows = glm::transpose(camera.clip());
    double worst = 0;
    for (int i : {0, 1, 3}) {
        glm::dvec4 error = run.clip_from_relative[size_t(i)] - rows[i];
        worst = std::max(worst, glm::length(error) / glm::length(rows[i]));
    }
    report.line(worst <= 32 * DBL_EPSILON, "clip_from_relative",
                "rows x, y, w off by %.3g relative", worst);
}

// The 32-bit position of a vertex is off by a few units of the scene's extent
// (matrix, products, sums), and so is the blend of three of them over w: 32
// units in all, seen at this depth as so many pixels.
static double tolerance(const PictureCamera &camera, double extent,
                        double depth)
{
    double world = rounding_share(32) * extent;
    return SUBPIXEL + world * camera.focal_length() / depth;
}

static void check_rays(const Run &run, const PictureCamera &camera,
                       double extent, Report &report)
{
    Receivers receivers(run);
    size_t wrong = 0, shown = 0;
    double worst = 0, bound = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown)
                continue;
            glm::dvec3 pixel = camera.pixel_of(r.position);
            double off = std::max(std::abs(pixel.x - x - 0.5),
                                  std::abs(pixel.y - y - 0.5));
            double allowed = tolerance(camera, extent, pixel.z);
            bound = std::max(bound, allowed);
            worst = std::max(worst, off);
            shown++;
            wrong += off <= allowed && pixel.z > 0 ? 0 : 1;
        }
    report.line(wrong == 0, "positions lie on the camera's rays",
                "%zu of %zu pixels do not, worst %.3g of at most %.3g pixel",
                wrong, shown, worst, bound);
}

void check_camera(const Run &run, const SceneTable &table, Report &report)
{
    const Camera &camera = table.scene.camera;
    double moved = glm::length(run.origin - vec3_of(camera.position));
    report.line(moved == 0, "origin is the camera's position", "off by %.3g",
                moved);
    PictureCamera own(camera, run.width, run.height);
    check_rows(run, own, report);
    check_rays(run, own, scene_extent(table.scene, run.origin), report);
}
