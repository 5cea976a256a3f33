#include "tests/oracle/filters/box_lookup.h"

#include <algorithm> // clamp, max, min
#include <cmath>     // abs, floor, round, sqrt

#include "tests/oracle/filters/chebyshev_bound.h" // store_share, table_absolute
#include "tests/oracle/filters/footprint.h"       // position_error
#include "tests/oracle/lib/rounding.h"

// GLSL lets inversesqrt be off by 2 units in the last place; drivers that make
// it of a reciprocal and a root by some more.
constexpr double ROOT_ERROR = 8 * UNIT_ROUNDOFF;

BoxLookup::BoxLookup(const Run &run) : settings_(run.settings)
{
    if (!settings_.adaptive_box)
        return;
    footprint_ = load_file(run, "footprint.exr", run.width, run.height, 4);
    for (size_t layer = 0; layer < run.views.size(); layer++) {
        Picture map = load_map(run, int(layer));
        layers_.push_back({sums_of(map, 0, settings_.downsample),
                           sums_of(map, 1, settings_.downsample)});
    }
}

BoxLookup::Sums BoxLookup::sums_of(const Picture &map, int channel, int factor)
{
    Sums table{map.width / factor, map.height / factor, {}};
    size_t row = size_t(table.width) + 1;
    table.sums.resize(row * (size_t(table.height) + 1));
    for (int y = 0; y < map.height; y++)
        for (int x = 0; x < map.width; x++)
            table.sums[(size_t(y / factor) + 1) * row + size_t(x / factor) +
                       1] +=
                (1 - double(map.at(x, y, channel))) / (factor * factor);
    for (size_t i = row; i < table.sums.size(); i++)
        table.sums[i] += i % row > 0 ? table.sums[i - 1] : 0;
    for (size_t i = row; i < table.sums.size(); i++)
        table.sums[i] += table.sums[i - row];
    return table;
}

// Of everything left of x and below y, in texels from the map's corner. Within
// a texel it grows evenly; outside the map there is nothing.
double BoxLookup::Sums::until(double x, double y) const
{
    x = std::clamp(x, 0.0, double(width));
    y = std::clamp(y, 0.0, double(height));
    int i = std::min(int(x), width - 1), j = std::min(int(y), height - 1);
    double wx = x - i, wy = y - j;
    const double *low = &sums[size_t(j) * (size_t(width) + 1) + size_t(i)];
    const double *high = low + width + 1;
    return (1 - wy) * ((1 - wx) * low[0] + wx * low[1]) +
           wy * ((1 - wx) * high[0] + wx * high[1]);
}

// M over the box around x, y.
double BoxLookup::Sums::mean(double x, double y, double box) const
{
    double half = box / 2;
    double sum = until(x + half, y + half) - until(x - half, y + half) -
                 until(x + half, y - half) + until(x - half, y - half);
    return 1 - sum / (box * box);
}

// Two over the root of how many texels the pixel covers, from 1 to the width
// that was asked for. The determinant is a difference: its rounding is a share
// of both products, and each of those has been rounded 4 times.
Interval BoxLookup::width(const Receiver &r, int x, int y) const
{
    const Sums &map = layers_[size_t(r.layer)][0];
    double scale =
        r.footprint_scale * r.footprint_scale * map.width * double(map.height);
    double one = double(footprint_.at(x, y, 0)) * footprint_.at(x, y, 3);
    double other = double(footprint_.at(x, y, 1)) * footprint_.at(x, y, 2);
    double error =
        rounding_share(8) * (std::abs(one) + std::abs(other)) * scale;
    double texels = std::abs(one - other) * scale;
    double most = 2 * settings_.radius + 1;
    auto root = [](double area) {
        return 2 / std::sqrt(std::max(area, 1e-12));
    };
    Interval box(root(texels + error), root(std::max(texels - error, 0.0)));
    return clamp(rounded(box, ROOT_ERROR), 1, most);
}

// Where a box's mean may have its extremes between low and high: at the ends,
// and where one of its edges cuts from one texel into the next.
static std::vector<double> centres(double x, double error, double box)
{
    std::vector<double> out = {x - error, x + error};
    for (double side : {-box / 2, box / 2}) {
        double kink = std::round(x + side) - side;
        if (std::abs(kink - x) < error)
            out.push_back(kink);
    }
    return out;
}

Interval BoxLookup::moment(const Receiver &r, int x, int y, int channel) const
{
    const Sums &map = layers_[size_t(r.layer)][size_t(channel)];
    Interval box = width(r, x, y);
    double u = r.u * map.width, v = r.v * map.height;
    // u * size is rounded, and so is each end of the box.
    double eu = position_error(r.u, map.width);
    double ev = position_error(r.v, map.height);
    std::vector<double> widths = {box.lo, box.hi};
    for (double middle : {u, v})
        for (double end : {box.lo, -box.lo}) {
            double kink = 2 * (std::round(middle + end / 2) - middle);
            if (std::abs(kink) > box.lo && std::abs(kink) < box.hi)
                widths.push_back(std::abs(kink));
        }
    Interval value = map.mean(u, v, widths[0]);
    for (double w : widths)
        for (double cy : centres(v, ev, w))
            for (double cx : centres(u, eu, w))
                value = hull(value, map.mean(cx, cy, w));
    int f = settings_.downsample;
    double small = f > 1 ? rounding_share(f * f + 1) + store_share(settings_) +
                               store_absolute(settings_)
                         : 0;
    // The table's integers and its 16 roundings: two for a part's product with
    // its weights, one for the integer, eight sums, the box's area, the
    // quotient and what is left of 1. 1 - M and all its parts are at most 1.
    return widened(value, small + table_absolute(settings_));
}
