#include <algorithm> // max
#include <cfloat>    // DBL_EPSILON
#include <cmath>     // abs, cos, tan

#include "tests/oracle/dump/light.h"
#include "tests/oracle/closed/matrix.h"
#include "tests/oracle/dump/projection.h"

static glm::dvec3 axis_of(const glm::dvec4 &row)
{
    return glm::dvec3(row);
}

// U and V without the half of W that moves the middle of the map to 1/2.
static glm::dvec3 across_of(const MapView &view, size_t row)
{
    return axis_of(view.rows[row]) - 0.5 * axis_of(view.rows[3]);
}

static void check_position(const Run &run, const Light &light,
                           const MapView &view, Report &report)
{
    glm::dvec3 expected = vec3_of(light.position) - run.origin;
    double world = glm::length(vec3_of(light.position)) +
                   glm::length(run.origin) + glm::length(expected);
    double off = glm::length(view.position - expected);
    for (size_t row : {0, 1, 3}) {
        glm::dvec3 axis = axis_of(view.rows[row]);
        double value = glm::dot(axis, expected) + view.rows[row].w;
        off = std::max(off, std::abs(value) / glm::length(axis));
    }
    report.line(off <= 32 * DBL_EPSILON * world,
                "the view is from the light's position", "off by %.3g", off);
}

// The axis of a spot's view is the light's direction, and those of a point's
// views are the world's axes, each once: the largest of six cosines with any
// direction is theirs.
static void check_axis(const Run &run, const Light &light, int layer,
                       Report &report)
{
    const MapView &view = run.views[size_t(layer)];
    glm::dvec3 axis = axis_of(view.rows[3]),
               expected = vec3_of(light.direction);
    size_t same = 0;
    if (view.lamp == Lamp::POINT) {
        expected = glm::dvec3(0);
        for (int k = 0; k < 3; k++)
            if (std::abs(axis[k]) > 0.9)
                expected[k] = axis[k] < 0 ? -1 : 1;
        for (const MapView &other : run.views)
            same += glm::dot(axis_of(other.rows[3]), axis) > 0.5 ? 1 : 0;
    }
    size_t count = view.lamp == Lamp::POINT ? 6 : 1;
    double off = glm::length(axis - expected);
    report.line(off <= 32 * DBL_EPSILON && same <= 1 &&
                    run.views.size() == count,
                "the view looks where the light does",
                "off by %.3g, %zu views of %zu", off, run.views.size(), count);
}

static void check_sides(const MapView &view, Report &report)
{
    glm::dvec3 u = glm::normalize(across_of(view, 0));
    glm::dvec3 v = glm::normalize(across_of(view, 1));
    glm::dvec3 w = glm::normalize(axis_of(view.rows[3]));
    double worst = std::max({std::abs(glm::dot(u, v)), std::abs(glm::dot(v, w)),
                             std::abs(glm::dot(w, u))});
    double turn = glm::dot(glm::cross(u, v), w);
    report.line(worst <= 64 * DBL_EPSILON && turn < 0,
                "right, up and the view's axis are orthogonal",
                "largest cosine %.3g, triple product %.3g", worst, turn);
}

// What the view answers for (a spot's cone, a point's 90 degrees) ends at the
// border, within 2 texels: from there on a filter finds its texels.
static void check_border(const MapView &view, Report &report)
{
    double inner = view.lamp == Lamp::SPOT ? std::tan(view.cone) : 1;
    double unused[2];
    const int size[2] = {view.width, view.height};
    for (size_t i = 0; i < 2; i++) {
        double edge = 0.5 - inner * glm::length(across_of(view, i));
        unused[i] = edge * size[i] - view.border;
    }
    double least = std::min(unused[0], unused[1]);
    double most = std::max(unused[0], unused[1]);
    report.line(least >= -1e-9 && most <= 2, "the view ends at the border",
                "%.3g and %.3g texels unused along u and v", unused[0],
                unused[1]);
}

// Everything that is lit up by the view has a depth in it.
static void check_seen(const Run &run, int layer, Report &report)
{
    const MapView &view = run.views[size_t(layer)];
    Receivers receivers(run);
    size_t outside = 0, seen = 0;
    double least = INFINITY, most = -INFINITY;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown || r.layer != layer || facing(r, view) == Facing::AWAY)
                continue;
            seen++;
            outside += inside_map(r) ? 0 : 1;
            least = std::min(least, r.t);
            most = std::max(most, r.t);
        }
    report.line(outside == 0, "the view holds what its light shines on",
                "%zu of %zu pixels outside, t from %.6g to %.6g", outside, seen,
                least, most);
}

// Fitted: nothing in the view is cut off, and what is not there costs no depth.
static void check_fitted(const Run &run, const SceneTable &table,
                         const MapView &view, Report &report)
{
    size_t outside = 0;
    double farthest = 0;
    for (int i = 0; i < table.scene.object_count; i++)
        for (const glm::dvec3 &p :
             object_points(table.scene.objects[i], run.origin)) {
            glm::dvec3 map = map_point(view, p);
            double w = glm::dot(view.rows[3], glm::dvec4(p, 1));
            bool held =
                w > 0 && map.x >= 0 && map.x <= 1 && map.y >= 0 && map.y <= 1;
            outside += held && !(map.z >= 0 && map.z <= 1) ? 1 : 0;
            farthest = std::max(farthest, glm::distance(p, view.position));
        }
    report.line(outside == 0 && view.near > 0 && view.near < view.far &&
                    view.far <= 1.01 * farthest,
                "near and far are fitted",
                "%.6g to %.6g, %zu corners cut off, farthest %.6g", view.near,
                view.far, outside, farthest);
}

void check_local_view(const Run &run, const SceneTable &table, int layer,
                      Report &report)
{
    const MapView &view = run.views[size_t(layer)];
    const Light &light = table.scene.light;
    check_position(run, light, view, report);
    check_axis(run, light, layer, report);
    check_sides(view, report);
    if (view.lamp == Lamp::SPOT)
        report.line(view.cone == light.cone, "the cone is the scene's",
                    "%.6g radians", view.cone);
    check_border(view, report);
    check_seen(run, layer, report);
    check_fitted(run, table, view, report);
}
