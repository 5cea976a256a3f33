// What the map would hold without a rasteriser.
#ifndef ORACLE_IDEAL_MAP_H
#define ORACLE_IDEAL_MAP_H

#include <glm/glm.hpp>
#include <array>
#include <unordered_map>
#include <vector>

#include "tests/oracle/dump.h"
#include "tests/oracle/rays.h"

// Ray cast depths at one place in every texel of a layer, in double.
class IdealMap
{
  public:
    IdealMap(const MapView &view, const RayScene &rays,
             const glm::dvec2 &place = {0.5, 0.5});

    // t; infinite outside the map and where there is nothing up to far.
    double at(int x, int y) const
    {
        return holds(x, y) ? depths_[size_t(y) * size_t(width_) + size_t(x)]
                           : INFINITY;
    }
    bool holds(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < width_ && y < height_;
    }
    // The same at four points of an outline's texel, else nothing: a
    // rasteriser keeps positions to 1/256 texel (8 bits, the least that GL
    // allows is 4), so a texel whose place is nearer than that to an outline
    // may hold either of two surfaces.
    const std::array<double, 4> *around(int x, int y) const
    {
        auto found = outline_.find(size_t(y) * size_t(width_) + size_t(x));
        return found == outline_.end() ? nullptr : &found->second;
    }
    static constexpr double SNAP = 1.0 / 256;
    static constexpr int SNAP_X[4] = {-1, 1, 0, 0}, SNAP_Y[4] = {0, 0, -1, 1};

    glm::dvec2 place() const // in texels from the lower left corner
    {
        return place_;
    }
    int width() const
    {
        return width_;
    }
    int height() const
    {
        return height_;
    }

  private:
    glm::dvec2 place_;
    int width_, height_;
    std::vector<double> depths_;
    std::unordered_map<size_t, std::array<double, 4>> outline_;
};

// The triangle's unit normal on the side of `direction`.
glm::dvec3 normal_towards(const Triangle &triangle,
                          const glm::dvec3 &direction);

#endif
