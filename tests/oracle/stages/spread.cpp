#include "tests/oracle/stages/spread.h"

#include <cmath> // floor, sqrt

#include "tests/oracle/lib/rounding.h"

Spread spread_at(const Picture &map, int x, int y)
{
    if (!map.holds(x, y))
        return {1, 0};
    return {double(map.at(x, y, 0)), double(map.at(x, y, 1))};
}

Spread merged(const std::vector<std::pair<double, Spread>> &parts)
{
    Spread all{0, 0};
    for (const auto &[weight, part] : parts)
        all.mean = all.mean + weight * part.mean;
    for (const auto &[weight, part] : parts)
        all.variance = all.variance +
                       weight * (part.variance + square(part.mean - all.mean));
    return all;
}

Spread hull(const Spread &a, const Spread &b)
{
    return {hull(a.mean, b.mean), hull(a.variance, b.variance)};
}

Spread bilinear_spread(const Picture &map, double x, double y)
{
    double left = std::floor(x), low = std::floor(y);
    double wx = x - left, wy = y - low;
    int i = int(left), j = int(low);
    return merged({{(1 - wx) * (1 - wy), spread_at(map, i, j)},
                   {wx * (1 - wy), spread_at(map, i + 1, j)},
                   {(1 - wx) * wy, spread_at(map, i, j + 1)},
                   {wx * wy, spread_at(map, i + 1, j + 1)}});
}

// As in proof.md of step 5's guard: 8 roundings of a sum of positive terms; the
// mean by one of itself and three of the deviation.
Spread rounded_once(const Spread &exact)
{
    double deviation = std::sqrt(std::max(exact.variance.hi, 0.0));
    Interval mean =
        widened(exact.mean, UNIT_ROUNDOFF / 2 + rounding_share(3) * deviation);
    return {mean, rounded(exact.variance, rounding_share(8))};
}

// How far apart the means are around a place.
static double range_around(const Picture &map, double x, double y)
{
    Interval all = spread_at(map, int(std::floor(x)), int(std::floor(y))).mean;
    for (int j = -1; j <= 2; j++)
        for (int i = -1; i <= 2; i++)
            all = hull(all, spread_at(map, int(std::floor(x)) + i,
                                      int(std::floor(y)) + j)
                                .mean);
    return all.width();
}

// Along one axis the variance is a parabola: its extremes are at the ends, or
// where a texel's centre is, or above them by less than the square of the
// step times the means' range.
Spread looked_up_spread(const Picture &map, double x, double y,
                        const std::vector<double> &shifts_x,
                        const std::vector<double> &shifts_y)
{
    Spread all = bilinear_spread(map, x, y);
    double step = 0;
    for (double dy : shifts_y)
        for (double dx : shifts_x) {
            all = hull(all, bilinear_spread(map, x + dx, y + dy));
            step = std::max({step, 2 * std::abs(dx), 2 * std::abs(dy)});
        }
    double bend = step * range_around(map, x, y);
    all.variance = widened(all.variance, 2 * bend * bend);
    // Two rows, then both of them. The rows' means are rounded, which moves the
    // deviation by no more.
    all = rounded_once(rounded_once(all));
    double deviation = std::sqrt(std::max(all.variance.hi, 0.0));
    double moved = UNIT_ROUNDOFF / 2 + rounding_share(4) * deviation;
    all.variance = widened(all.variance, 2 * deviation * moved + moved * moved);
    all.variance = maximum(all.variance, 0);
    return all;
}
