// What the map would hold without a rasteriser.
#ifndef ORACLE_IDEAL_MAP_H
#define ORACLE_IDEAL_MAP_H

#include <glm/glm.hpp>
#include <array>
#include <memory> // unique_ptr
#include <mutex>  // once_flag
#include <unordered_map>

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/rays/rays.h"

// Ray cast depths at one place in every texel of a layer, in double. Cast when
// they are first asked for, a block of texels at a time: most of a cube's map
// is seen by nobody. Any number of threads may ask; `rays` has to stay.
class IdealMap
{
  public:
    IdealMap(const MapView &view, const RayScene &rays,
             const glm::dvec2 &place = {0.5, 0.5});

    // t; infinite outside the map and where there is nothing up to far.
    double at(int x, int y) const
    {
        return holds(x, y) ? block(x, y).depths[x % BLOCK] : INFINITY;
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
        if (!holds(x, y))
            return nullptr;
        const auto &outline = block(x, y).outline;
        auto found = outline.find(x);
        return found == outline.end() ? nullptr : &found->second;
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
    static constexpr int BLOCK = 16; // texels along a row

    struct Block {
        std::once_flag cast;
        double depths[BLOCK];
        std::unordered_map<int, std::array<double, 4>> outline; // by x
    };

    const Block &block(int x, int y) const;
    void cast(Block &block, int first, int y) const;

    const MapView *view_;
    const RayScene *rays_;
    glm::dvec2 place_;
    int width_, height_;
    std::unique_ptr<Block[]> blocks_; // by row
};

// The triangle's unit normal on the side of `direction`.
glm::dvec3 normal_towards(const Triangle &triangle,
                          const glm::dvec3 &direction);

#endif
