#include "tests/oracle/mip_levels.h"

#include <algorithm> // max, min
#include <cmath>     // atan2, ceil, exp2, floor, log2

#include "tests/oracle/footprint.h" // position_error
#include "tests/oracle/rounding.h"

// GLSL does not say how exact log2 is on every driver; a level's error of this
// much is far below what 8 bits of a GPU's own would be.
static constexpr double LEVEL_ERROR = 1e-4;
// Of the ellipse's axes: some ten operations, and the cancellation in the
// eigenvector where the axes differ by half or more.
static constexpr double AXIS_ERROR = 4e-6;
// Of the ratio of the axes, whose determinant cancels up to 16 times as much.
static constexpr double RATIO_ERROR = 1e-4;

std::vector<Picture> load_levels(const Run &run, int layer)
{
    std::vector<Picture> levels = {load_filtered(run, layer)};
    int width = levels[0].width, height = levels[0].height;
    std::string name = "blurred." + std::to_string(layer) + ".m";
    while (width % 2 == 0 && height % 2 == 0) {
        width /= 2;
        height /= 2;
        levels.push_back(
            load_file(run, name + std::to_string(levels.size()) + ".exr", width,
                      height, 2));
    }
    return levels;
}

// Half the width of what a level's lookup reads, by adding up: the blur, 1.5
// texels of each level that was halved, and one of the level's own.
double MipLookup::reach(double level) const
{
    double sum = radius_ + std::exp2(level);
    for (int finer = 0; finer < int(level); finer++)
        sum += 1.5 * std::exp2(finer);
    return sum;
}

MipLookup::MipLookup(const Run &run)
    : free_(INFINITY), anisotropy_(run.settings.anisotropy),
      hardware_(run.settings.hardware), radius_(run.settings.radius)
{
    if (!run.settings.mips)
        return;
    footprint_ = load_file(run, "footprint.exr", run.width, run.height, 4);
    for (size_t layer = 0; layer < run.views.size(); layer++)
        levels_.push_back(load_levels(run, int(layer)));
    const MapView &view = run.views[0];
    if (view.lamp != Lamp::POINT)
        return;
    free_ = std::floor(view.border / run.settings.downsample);
    for (auto &chain : levels_)
        while (chain.size() > 1 && reach(double(chain.size() - 1)) > free_)
            chain.pop_back();
}

static double texel(const Picture &map, int x, int y, int channel)
{
    return map.holds(x, y) ? double(map.at(x, y, channel)) : 1.0;
}

static double bilinear(const Picture &map, double x, double y, int channel)
{
    double left = std::floor(x), low = std::floor(y);
    double wx = x - left, wy = y - low;
    int i = int(left), j = int(low);
    return (1 - wy) * ((1 - wx) * texel(map, i, j, channel) +
                       wx * texel(map, i + 1, j, channel)) +
           wy * ((1 - wx) * texel(map, i, j + 1, channel) +
                 wx * texel(map, i + 1, j + 1, channel));
}

static std::vector<double> places(double x, double error)
{
    std::vector<double> out = {x - error, x + error};
    if (std::abs(std::round(x) - x) < error)
        out.push_back(std::round(x));
    return out;
}

// The extremes of a bilinear function over a rectangle are at its corners, or
// where a texel's centre cuts it.
static Interval looked_up(const Picture &map, double u, double v,
                          double tap_error, int channel)
{
    double ex = position_error(u, map.width) + tap_error * map.width;
    double ey = position_error(v, map.height) + tap_error * map.height;
    double x = u * map.width - 0.5, y = v * map.height - 0.5;
    Interval value = bilinear(map, x, y, channel);
    for (double py : places(y, ey))
        for (double px : places(x, ex))
            value = hull(value, bilinear(map, px, py, channel));
    return widened(value, rounding_share(6)); // moments are at most 1
}

Interval MipLookup::at_level(const Receiver &r, double u, double v,
                             double tap_error, double level, int channel) const
{
    const std::vector<Picture> &levels = levels_[size_t(r.layer)];
    double last = double(levels.size() - 1);
    level = std::clamp(level, 0.0, last);
    size_t fine = size_t(level);
    size_t coarse = std::min(fine + 1, levels.size() - 1);
    double part = level - double(fine);
    return (1 - part) * looked_up(levels[fine], u, v, tap_error, channel) +
           part * looked_up(levels[coarse], u, v, tap_error, channel);
}

// The mean of the taps, over every level that rounding can make of one.
Interval MipLookup::along(const Receiver &r, const double direction[2],
                          double longer, double shorter, int taps,
                          int channel) const
{
    const Picture &finest = levels_[size_t(r.layer)][0];
    double tap_length = longer / taps;
    double level = std::log2(std::max({shorter, tap_length, 1.0}));
    double error =
        taps == 1 ? 0
                  : AXIS_ERROR * longer / std::min(finest.width, finest.height);
    Interval all(1e9, -1e9);
    std::vector<double> levels = places(level, LEVEL_ERROR);
    if (hardware_)
        levels = {level - 1, std::floor(level), level, std::ceil(level),
                  level + 1};
    double last = double(levels_[size_t(r.layer)].size() - 1);
    for (double l : levels) {
        double coarse = std::ceil(std::clamp(l, 0.0, last));
        double room = std::max(free_ - reach(coarse), 0.0);
        double outermost = std::min((taps - 1) * tap_length / 2, room);
        Interval sum = 0;
        for (int i = 0; i < taps; i++) {
            double steps =
                taps == 1 ? 0 : (2.0 * i / (taps - 1) - 1) * outermost;
            sum = sum + at_level(r, r.u + steps * direction[0] / finest.width,
                                 r.v + steps * direction[1] / finest.height,
                                 error, l, channel);
        }
        all = hull(all, sum / double(taps));
    }
    return widened(all, rounding_share(taps + 6));
}

// Places of the steps in texels; the ellipse's angle from its quadratic form.
Interval MipLookup::moment(const Receiver &r, int x, int y, int channel) const
{
    const Picture &finest = levels_[size_t(r.layer)][0];
    double wide = r.footprint_scale * finest.width;
    double high = r.footprint_scale * finest.height;
    double ax = double(footprint_.at(x, y, 0)) * wide;
    double ay = double(footprint_.at(x, y, 1)) * high;
    double bx = double(footprint_.at(x, y, 2)) * wide;
    double by = double(footprint_.at(x, y, 3)) * high;
    double angle = std::atan2(2 * (ax * ay + bx * by),
                              ax * ax + bx * bx - ay * ay - by * by) /
                   2;
    double direction[2] = {std::cos(angle), std::sin(angle)};
    double longer = std::hypot(ax * direction[0] + ay * direction[1],
                               bx * direction[0] + by * direction[1]);
    double shorter = std::hypot(ay * direction[0] - ax * direction[1],
                                by * direction[0] - bx * direction[1]);
    double ratio = longer / std::max(shorter, 1.0);
    auto taps = [&](double share) {
        double most = anisotropy_;
        return int(std::clamp(ratio * share, 1.0, most) + 0.5);
    };
    int few = taps(1 - RATIO_ERROR), many = taps(1 + RATIO_ERROR);
    Interval value = along(r, direction, longer, shorter, few, channel);
    if (many != few)
        value =
            hull(value, along(r, direction, longer, shorter, many, channel));
    return value;
}
