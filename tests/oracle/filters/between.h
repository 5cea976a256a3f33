// A bilinear lookup at a place that is known within an error.
#ifndef ORACLE_BETWEEN_H
#define ORACLE_BETWEEN_H

#include <cmath> // abs, floor, round
#include <vector>

#include "tests/oracle/filters/footprint.h" // position_error
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/lib/picture.h"

// The bilinear mean at (x, y), where texel(i, j) is the value at whole numbers.
template <typename Texel> double bilinear(double x, double y, Texel texel)
{
    double left = std::floor(x), low = std::floor(y);
    double wx = x - left, wy = y - low;
    int i = int(left), j = int(low);
    return (1 - wy) * ((1 - wx) * texel(i, j) + wx * texel(i + 1, j)) +
           wy * ((1 - wx) * texel(i, j + 1) + wx * texel(i + 1, j + 1));
}

// The extremes of a bilinear function over a rectangle are at its corners, or
// where a texel's centre cuts it: if it is narrower than a texel.
inline std::vector<double> extreme_places(double x, double error)
{
    std::vector<double> out = {x - error, x + error};
    if (std::abs(std::round(x) - x) < error)
        out.push_back(std::round(x));
    return out;
}

// What (u, v), give or take `error` and what 32-bit arithmetic makes of a
// place, may look up in the map; the lookup's own rounding is left out.
template <typename Texel>
Interval between_texels(const Picture &map, double u, double v, double error,
                        Texel texel)
{
    double ex = position_error(u, map.width) + error * map.width;
    double ey = position_error(v, map.height) + error * map.height;
    double x = u * map.width - 0.5, y = v * map.height - 0.5;
    Interval value = bilinear(x, y, texel);
    for (double py : extreme_places(y, ey))
        for (double px : extreme_places(x, ex))
            value = hull(value, bilinear(px, py, texel));
    return value;
}

#endif
