#include "tests/oracle/depth_lookup.h"

#include <cmath> // abs, ceil, floor, round

#include "tests/oracle/footprint.h" // position_error

double Average::operator()(double first, double second) const
{
    double before = t - first;
    if (!squared)
        return before;
    double variance = central ? second : second - first * first;
    return variance + before * before;
}

static double texel(const Picture &map, int x, int y, const Average &of)
{
    if (!map.holds(x, y))
        return of(1, of.central ? 0 : 1);
    return of(double(map.at(x, y, 0)), double(map.at(x, y, 1)));
}

static double bilinear(const Picture &map, double x, double y,
                       const Average &of)
{
    double left = std::floor(x), low = std::floor(y);
    double wx = x - left, wy = y - low;
    int i = int(left), j = int(low);
    return (1 - wy) * ((1 - wx) * texel(map, i, j, of) +
                       wx * texel(map, i + 1, j, of)) +
           wy * ((1 - wx) * texel(map, i, j + 1, of) +
                 wx * texel(map, i + 1, j + 1, of));
}

static std::vector<double> places(double x, double error)
{
    std::vector<double> out = {x - error, x + error};
    if (std::abs(std::round(x) - x) < error)
        out.push_back(std::round(x));
    return out;
}

// The extremes of a bilinear function over a rectangle are at its corners, or
// where a texel's centre cuts it: if it is narrower than a texel.
static Interval between_texels(const Picture &map, double u, double v,
                               double error, const Average &of)
{
    double ex = position_error(u, map.width) + error * map.width;
    double ey = position_error(v, map.height) + error * map.height;
    double x = u * map.width - 0.5, y = v * map.height - 0.5;
    Interval value = bilinear(map, x, y, of);
    for (double py : places(y, ey))
        for (double px : places(x, ex))
            value = hull(value, bilinear(map, px, py, of));
    return value;
}

// Linear in the level between whole ones.
Interval between_levels(const std::vector<Picture> &levels, double u, double v,
                        double error, Interval level, const Average &of)
{
    double last = double(levels.size() - 1);
    level = clamp(level, 0, last);
    std::vector<double> stops = {level.lo, level.hi};
    for (double whole = std::ceil(level.lo); whole < level.hi; whole++)
        stops.push_back(whole);
    Interval all(1e9, -1e9);
    for (double stop : stops) {
        size_t fine = size_t(stop);
        double part = stop - double(fine);
        Interval value = between_texels(levels[fine], u, v, error, of);
        if (part > 0)
            value = (1 - part) * value +
                    part * between_texels(levels[fine + 1], u, v, error, of);
        all = hull(all, value);
    }
    return all;
}
