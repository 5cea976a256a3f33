#include "tests/oracle/ideal_map.h"

#include "tests/oracle/parallel.h"
#include "tests/oracle/projection.h"
#include "tests/oracle/ray_checks.h" // map_ray

IdealMap::IdealMap(const MapView &view, const RayScene &rays)
    : width_(view.width), height_(view.height),
      depths_(size_t(view.width) * size_t(view.height))
{
    // A surface may lie exactly in the near plane: start a little before it.
    double start = -1e-6;
    parallel_rows(height_, [&](int y) {
        for (int x = 0; x < width_; x++) {
            Ray ray =
                map_ray(view, (x + 0.5) / width_, (y + 0.5) / height_, start);
            double t = rays.first(ray).distance + start;
            depths_[size_t(y) * size_t(width_) + size_t(x)] =
                t <= 1 ? t : INFINITY;
        }
    });
}

// n.p is constant on the plane; p is linear in u, v and t.
MapPlane plane_of(const glm::dvec3 &point, const MapView &view,
                  const glm::dvec3 &normal)
{
    glm::dvec3 zero = point_of_map(view, {0, 0, 0});
    double du = glm::dot(normal, point_of_map(view, {1, 0, 0}) - zero);
    double dv = glm::dot(normal, point_of_map(view, {0, 1, 0}) - zero);
    double dt = glm::dot(normal, point_of_map(view, {0, 0, 1}) - zero);
    return {point.x, point.y, point.z, -du / dt, -dv / dt};
}

glm::dvec3 normal_towards(const Triangle &triangle, const glm::dvec3 &direction)
{
    glm::dvec3 n = glm::normalize(triangle.normal());
    return glm::dot(n, direction) < 0 ? -n : n;
}
