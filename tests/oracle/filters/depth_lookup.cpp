#include "tests/oracle/filters/depth_lookup.h"

#include <cmath> // ceil

#include "tests/oracle/filters/between.h" // between_texels

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

static Interval average(const Picture &map, double u, double v, double error,
                        const Average &of)
{
    return between_texels(map, u, v, error,
                          [&](int x, int y) { return texel(map, x, y, of); });
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
        Interval value = average(levels[fine], u, v, error, of);
        if (part > 0)
            value = (1 - part) * value +
                    part * average(levels[fine + 1], u, v, error, of);
        all = hull(all, value);
    }
    return all;
}
