#include "tests/oracle/rays/texel_depths.h"

#include <cmath> // INFINITY
#include <vector>

#include "tests/oracle/dump/projection.h"
#include "tests/oracle/lib/rounding.h"

using Polygon = std::vector<glm::dvec3>;

// The part of a convex polygon where dot(plane, (p, 1)) >= 0.
static Polygon clipped(const Polygon &polygon, const glm::dvec4 &plane)
{
    Polygon kept;
    for (size_t i = 0; i < polygon.size(); i++) {
        const glm::dvec3 &p = polygon[i];
        const glm::dvec3 &next = polygon[(i + 1) % polygon.size()];
        double here = glm::dot(plane, glm::dvec4(p, 1));
        double there = glm::dot(plane, glm::dvec4(next, 1));
        if (here >= 0)
            kept.push_back(p);
        if ((here >= 0) != (there >= 0))
            kept.push_back(glm::mix(p, next, here / (here - there)));
    }
    return kept;
}

// u >= low is U - low W >= 0 where W is positive, and u <= high likewise; both
// together leave nothing where it is negative.
static Polygon in_square(const MapView &view, const Triangle &triangle,
                         const glm::dvec2 &middle, double reach)
{
    const glm::dvec4 &w = view.rows[3];
    const int size[2] = {view.width, view.height};
    Polygon polygon = {triangle.a, triangle.b, triangle.c};
    for (int axis = 0; axis < 2; axis++) {
        const glm::dvec4 &row = view.rows[size_t(axis)];
        double low = (middle[axis] - reach) / size[axis];
        double high = (middle[axis] + reach) / size[axis];
        polygon = clipped(polygon, row - low * w);
        polygon = clipped(polygon, high * w - row);
    }
    return polygon;
}

bool overlaps(const MapView &view, const Triangle &triangle,
              const glm::dvec2 &middle, double reach)
{
    return !in_square(view, triangle, middle, reach).empty();
}

static double stored_depth_of(const MapView &view, const glm::dvec3 &point)
{
    glm::dvec3 map = map_point(view, point);
    return stored_depth(view, map.x, map.y, map.z);
}

// A depth along an axis is linear on a plane, and z / w is so in the map: the
// extremes are at corners. A distance is convex: its least value may be inside,
// but not below its tangent plane at any point.
static double least_depth(const MapView &view, const Polygon &polygon)
{
    bool distance = !view.parallel() && !view.projected;
    glm::dvec3 middle(0);
    for (const glm::dvec3 &p : polygon)
        middle += p / double(polygon.size());
    glm::dvec3 slope =
        glm::normalize(middle - view.position) / (view.far - view.near);
    double least = INFINITY;
    for (const glm::dvec3 &p : polygon) {
        double depth = distance ? stored_depth_of(view, middle) +
                                      glm::dot(slope, p - middle)
                                : stored_depth_of(view, p);
        least = std::min(least, depth);
    }
    return least;
}

bool depths_in_texel(const MapView &view, const Triangle &triangle, int x,
                     int y, Interval &depths)
{
    Polygon polygon =
        in_square(view, triangle, {x + 0.5, y + 0.5}, 0.5 + SUBPIXEL);
    if (polygon.empty())
        return false;
    double most = -INFINITY;
    for (const glm::dvec3 &p : polygon)
        most = std::max(most, stored_depth_of(view, p));
    depths = clamp({least_depth(view, polygon), most}, 0, 1);
    return true;
}
