#include "tests/oracle/ideal_map.h"

#include <cmath> // abs, isinf

#include "tests/oracle/parallel.h"
#include "tests/oracle/projection.h"
#include "tests/oracle/ray_checks.h" // map_ray

// The depth t at u and v; infinite where there is nothing up to far.
static double depth_at(const MapView &view, const RayScene &rays, double u,
                       double v)
{
    // A surface may lie exactly in the near plane: start a little before it.
    double start = -1e-6;
    Ray ray = map_ray(view, u, v, start);
    if (before_near(view, rays, ray, start))
        return 0;
    double t = rays.first(ray).distance + start;
    return t <= 1 ? t : INFINITY;
}

// Whether the five depths are not those of one plane through the texel.
static bool bends(double middle, const std::array<double, 4> &around)
{
    bool flat = std::abs(around[0] + around[1] - 2 * middle) < 1e-7 &&
                std::abs(around[2] + around[3] - 2 * middle) < 1e-7;
    bool empty = std::isinf(middle) && std::isinf(around[0]) &&
                 std::isinf(around[1]) && std::isinf(around[2]) &&
                 std::isinf(around[3]);
    return !flat && !empty;
}

IdealMap::IdealMap(const MapView &view, const RayScene &rays,
                   const glm::dvec2 &place)
    : place_(place), width_(view.width), height_(view.height),
      depths_(size_t(view.width) * size_t(view.height))
{
    std::vector<std::vector<std::pair<size_t, std::array<double, 4>>>> found(
        static_cast<size_t>(height_));
    parallel_rows(height_, [&](int y) {
        for (int x = 0; x < width_; x++) {
            std::array<double, 4> around;
            auto depth = [&](double dx, double dy) {
                return depth_at(view, rays, (x + place.x + dx) / width_,
                                (y + place.y + dy) / height_);
            };
            for (size_t k = 0; k < 4; k++)
                around[k] = depth(SNAP * SNAP_X[k], SNAP * SNAP_Y[k]);
            size_t index = size_t(y) * size_t(width_) + size_t(x);
            depths_[index] = depth(0, 0);
            if (bends(depths_[index], around))
                found[size_t(y)].emplace_back(index, around);
        }
    });
    for (const auto &row : found)
        outline_.insert(row.begin(), row.end());
}

glm::dvec3 normal_towards(const Triangle &triangle, const glm::dvec3 &direction)
{
    glm::dvec3 n = glm::normalize(triangle.normal());
    return glm::dot(n, direction) < 0 ? -n : n;
}
