#include <algorithm> // max
#include <cfloat>    // DBL_EPSILON
#include <cmath>     // abs

#include "tests/oracle/closed/matrix.h"
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/lib/rounding.h"

// The rows are doubles; sums of a few products of the size of the scene's
// world coordinates, and their differences to the origin, cost some ulp.
static double double_error(const Run &run, const SceneTable &table,
                           const MapView &view)
{
    double world = scene_extent(table.scene, glm::dvec3(0));
    for (int i = 0; i < 3; i++)
        world = std::max(world, std::abs(run.origin[i]));
    double rows = 0;
    for (const glm::dvec4 &row : view.rows)
        rows = std::max(rows, glm::length(glm::dvec3(row)));
    return 32 * DBL_EPSILON * (1 + 3 * world * rows);
}

static void check_depth_row(const Run &run, const SceneTable &table,
                            const MapView &view, double tolerance,
                            Report &report)
{
    const Light &light = table.scene.light;
    double range = view.far - view.near;
    glm::dvec3 expected = vec3_of(light.direction) / range;
    double turned = glm::length(glm::dvec3(view.rows[2]) - expected) * range;
    report.line(turned <= 32 * DBL_EPSILON, "T row is direction / (far - near)",
                "relative error %.3g", turned);

    glm::dvec3 anchor = vec3_of(light.anchor) - run.origin;
    double t = map_point(view, anchor).z, at = -view.near / range;
    // near and far may be large against their difference.
    double bound = tolerance + 8 * DBL_EPSILON * std::abs(at);
    report.line(std::abs(t - at) <= bound, "depth of the light's anchor",
                "t %.6g, expected %.6g, error %.3g", t, at, std::abs(t - at));
    bool given = !view.split() && (light.near != 0 || light.far != 0);
    if (given)
        report.line(view.near == light.near && view.far == light.far,
                    "near and far are the scene's", "%.6g to %.6g", view.near,
                    view.far);
}

static void check_orthogonal(const MapView &view, Report &report)
{
    glm::dvec3 axis[3];
    for (size_t i = 0; i < 3; i++)
        axis[i] = glm::normalize(glm::dvec3(view.rows[i]));
    double worst = std::max({std::abs(glm::dot(axis[0], axis[1])),
                             std::abs(glm::dot(axis[1], axis[2])),
                             std::abs(glm::dot(axis[2], axis[0]))});
    // Rows from cross products of unit vectors: some ulp each.
    report.line(worst <= 32 * DBL_EPSILON, "U, V and T are orthogonal",
                "largest cosine %.3g", worst);
}

namespace
{

struct Unused { // texels between the casters and the border
    double left, right, below, above;
};

} // namespace

// The casters touch the border, within 2 texels, on all four sides. Where the
// texels are square in the world, only along the longer side of the casters;
// along the other they are in the middle.
static void check_tight(const Unused &unused, const MapView &view,
                        Report &report)
{
    double across = std::max(unused.left, unused.right);
    double up = std::max(unused.below, unused.above);
    double texels_x = glm::length(glm::dvec3(view.rows[0])) * view.width;
    double texels_y = glm::length(glm::dvec3(view.rows[1])) * view.height;
    bool square = std::abs(texels_x / texels_y - 1) <= 1e-9;
    bool middle = std::abs(unused.left - unused.right) <= 2 &&
                  std::abs(unused.below - unused.above) <= 2;
    bool tight = std::max(across, up) <= 2 ||
                 (square && middle && std::min(across, up) <= 2);
    report.line(tight, "the map's rectangle is tight",
                "left %.3g, right %.3g, below %.3g, above %.3g texels unused, "
                "texels %s",
                unused.left, unused.right, unused.below, unused.above,
                square ? "square" : "not square");
}

// The casters' bounds in the map lie inside the border.
static void check_fit(const Run &run, const SceneTable &table,
                      const MapView &view, double tolerance, Report &report)
{
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (int i = 0; i < table.scene.object_count; i++) {
        const Object &object = table.scene.objects[i];
        if (!object.casts)
            continue;
        for (const glm::dvec3 &p : object_points(object, run.origin)) {
            low = glm::min(low, map_point(view, p));
            high = glm::max(high, map_point(view, p));
        }
    }
    if (low.x > high.x) {
        report.line(true, "casters inside the border", "no casters");
        return;
    }
    double left = low.x * view.width - view.border;
    double right = (1 - high.x) * view.width - view.border;
    double below = low.y * view.height - view.border;
    double above = (1 - high.y) * view.height - view.border;
    double least = std::min({left, right, below, above});
    double slack = tolerance * std::max(view.width, view.height);
    report.line(least >= -slack && low.z >= -tolerance &&
                    high.z <= 1 + tolerance,
                "casters inside the border",
                "least distance to it %.3g texels, t from %.6g to %.6g", least,
                low.z, high.z);
    check_tight({left, right, below, above}, view, report);
}

// Fitted near and far hold everything inside the rectangle.
static void check_range(const Run &run, const MapView &view, int layer,
                        Report &report)
{
    Receivers receivers(run);
    size_t outside = 0, seen = 0;
    double slack = 0, least = INFINITY, most = -INFINITY;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown || r.layer != layer || r.u < 0 || r.u > 1 || r.v < 0 ||
                r.v > 1)
                continue;
            double size = std::abs(view.rows[2].w);
            for (int i = 0; i < 3; i++)
                size += std::abs(view.rows[2][i] * r.position[i]);
            slack = rounding_share(16) * size; // the position's and t's own
            seen++;
            outside += r.t >= -slack && r.t <= 1 + slack ? 0 : 1;
            least = std::min(least, r.t);
            most = std::max(most, r.t);
        }
    report.line(outside == 0, "fitted near and far hold what is seen",
                "%zu of %zu pixels outside, t from %.6g to %.6g", outside, seen,
                least, most);
}

void check_view(const Run &run, const SceneTable &table, int layer,
                Report &report)
{
    const MapView &view = run.views[size_t(layer)];
    report.line(int(view.lamp) == int(table.scene.light.kind),
                "the light is of the scene's kind", "%d", int(view.lamp));
    if (!view.parallel())
        return check_local_view(run, table, layer, report);
    double tolerance = double_error(run, table, view);
    check_depth_row(run, table, view, tolerance, report);
    check_orthogonal(view, report);
    if (view.split())
        return check_split(run, table, layer, report);
    check_fit(run, table, view, tolerance, report);
    if (table.scene.light.near == 0 && table.scene.light.far == 0)
        check_range(run, view, layer, report);
}
