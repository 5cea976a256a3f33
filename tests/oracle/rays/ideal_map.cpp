#include "tests/oracle/rays/ideal_map.h"

#include <algorithm> // min
#include <cmath>     // abs, isinf

#include "tests/oracle/dump/projection.h"
#include "tests/oracle/rays/ray_checks.h" // map_ray

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

static int blocks_along(int width, int block)
{
    return (width + block - 1) / block;
}

IdealMap::IdealMap(const MapView &view, const RayScene &rays,
                   const glm::dvec2 &place)
    : view_(&view), rays_(&rays), place_(place), width_(view.width),
      height_(view.height),
      blocks_(new Block[size_t(blocks_along(width_, BLOCK)) * size_t(height_)])
{
}

const IdealMap::Block &IdealMap::block(int x, int y) const
{
    int column = x / BLOCK;
    Block &found = blocks_[size_t(y) * size_t(blocks_along(width_, BLOCK)) +
                           size_t(column)];
    std::call_once(found.cast, [&] { cast(found, column * BLOCK, y); });
    return found;
}

void IdealMap::cast(Block &block, int first, int y) const
{
    for (int x = first; x < std::min(first + BLOCK, width_); x++) {
        std::array<double, 4> around;
        auto depth = [&](double dx, double dy) {
            return depth_at(*view_, *rays_, (x + place_.x + dx) / width_,
                            (y + place_.y + dy) / height_);
        };
        for (size_t k = 0; k < 4; k++)
            around[k] = depth(SNAP * SNAP_X[k], SNAP * SNAP_Y[k]);
        block.depths[x - first] = depth(0, 0);
        if (bends(block.depths[x - first], around))
            block.outline.emplace(x, around);
    }
}

glm::dvec3 normal_towards(const Triangle &triangle, const glm::dvec3 &direction)
{
    glm::dvec3 n = glm::normalize(triangle.normal());
    return glm::dot(n, direction) < 0 ? -n : n;
}
