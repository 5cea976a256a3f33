#include "tests/oracle/filters/mip_levels.h"

#include <algorithm> // max, min
#include <cmath>     // atan2, ceil, exp2, floor, log2

#include "tests/oracle/filters/between.h"   // between_texels
#include "tests/oracle/filters/footprint.h" // position_error
#include "tests/oracle/lib/rounding.h"

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
    if (!run.settings.mips || run.settings.soft)
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

static Interval looked_up(const Picture &map, double u, double v,
                          double tap_error, int channel)
{
    Interval value = between_texels(map, u, v, tap_error, [&](int x, int y) {
        return texel(map, x, y, channel);
    });
    return widened(value, rounding_share(6)); // moments are at most 1
}

namespace
{

// One channel of raw moments: every average is linear.
struct ChannelLookup {
    using Value = Interval;
    int channel;

    Value at(const Picture &map, double u, double v, double tap_error) const
    {
        return looked_up(map, u, v, tap_error, channel);
    }
    Value blended(Value fine, Value coarse, double part) const
    {
        return (1 - part) * fine + part * coarse;
    }
    Value averaged(const std::vector<Value> &taps) const
    {
        Value sum = 0;
        for (Value tap : taps)
            sum = sum + tap;
        double n = double(taps.size());
        return widened(sum / n, rounding_share(int(taps.size()) + 6));
    }
};

struct SpreadLookup {
    using Value = Spread;

    Value at(const Picture &map, double u, double v, double tap_error) const
    {
        double ex = position_error(u, map.width) + tap_error * map.width;
        double ey = position_error(v, map.height) + tap_error * map.height;
        double x = u * map.width - 0.5, y = v * map.height - 0.5;
        auto shifts = [](double place, double error) {
            std::vector<double> all = extreme_places(place, error);
            for (double &p : all)
                p -= place;
            return all;
        };
        return looked_up_spread(map, x, y, shifts(x, ex), shifts(y, ey));
    }
    Value blended(const Value &fine, const Value &coarse, double part) const
    {
        return rounded_once(merged({{1 - part, fine}, {part, coarse}}));
    }
    // Of n taps about the first, see proof.md of step 5's guard.
    Value averaged(const std::vector<Value> &taps) const
    {
        double n = double(taps.size());
        std::vector<std::pair<double, Spread>> parts;
        for (const Value &tap : taps)
            parts.push_back({1 / n, tap});
        Value all = merged(parts);
        if (taps.size() == 1)
            return all;
        double deviation = std::sqrt(std::max(all.variance.hi, 0.0));
        all.mean =
            widened(all.mean, UNIT_ROUNDOFF / 2 + (n + 4) * UNIT_ROUNDOFF *
                                                      std::sqrt(n) * deviation);
        all.variance = rounded(all.variance, (3 * n + 15) * UNIT_ROUNDOFF * n);
        return all;
    }
};

} // namespace

template <class Lookup>
typename Lookup::Value
MipLookup::at_level(const Lookup &lookup, const Receiver &r, double u, double v,
                    double tap_error, double level) const
{
    const std::vector<Picture> &levels = levels_[size_t(r.layer)];
    double last = double(levels.size() - 1);
    level = std::clamp(level, 0.0, last);
    size_t fine = size_t(level);
    size_t coarse = std::min(fine + 1, levels.size() - 1);
    double part = level - double(fine);
    return lookup.blended(lookup.at(levels[fine], u, v, tap_error),
                          lookup.at(levels[coarse], u, v, tap_error), part);
}

// The mean of the taps, over every level that rounding can make of one.
template <class Lookup>
typename Lookup::Value MipLookup::along(const Lookup &lookup, const Receiver &r,
                                        const double direction[2],
                                        double longer, double shorter,
                                        int taps) const
{
    const Picture &finest = levels_[size_t(r.layer)][0];
    double tap_length = longer / taps;
    double level = std::log2(std::max({shorter, tap_length, 1.0}));
    double error =
        taps == 1 ? 0
                  : AXIS_ERROR * longer / std::min(finest.width, finest.height);
    std::vector<typename Lookup::Value> all;
    std::vector<double> levels = extreme_places(level, LEVEL_ERROR);
    if (hardware_)
        levels = {level - 1, std::floor(level), level, std::ceil(level),
                  level + 1};
    double last = double(levels_[size_t(r.layer)].size() - 1);
    for (double l : levels) {
        double coarse = std::ceil(std::clamp(l, 0.0, last));
        double room = std::max(free_ - reach(coarse), 0.0);
        double outermost = std::min((taps - 1) * tap_length / 2, room);
        std::vector<typename Lookup::Value> found;
        for (int i = 0; i < taps; i++) {
            double steps =
                taps == 1 ? 0 : (2.0 * i / (taps - 1) - 1) * outermost;
            found.push_back(
                at_level(lookup, r, r.u + steps * direction[0] / finest.width,
                         r.v + steps * direction[1] / finest.height, error, l));
        }
        all.push_back(lookup.averaged(found));
    }
    typename Lookup::Value value = all[0];
    for (const auto &other : all)
        value = hull(value, other);
    return value;
}

// Places of the steps in texels; the ellipse's angle from its quadratic form.
template <class Lookup>
typename Lookup::Value
MipLookup::at_pixel(const Lookup &lookup, const Receiver &r, int x, int y) const
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
    auto value = along(lookup, r, direction, longer, shorter, few);
    if (many != few)
        value = hull(value, along(lookup, r, direction, longer, shorter, many));
    return value;
}

Interval MipLookup::moment(const Receiver &r, int x, int y, int channel) const
{
    return at_pixel(ChannelLookup{channel}, r, x, y);
}

Spread MipLookup::spread(const Receiver &r, int x, int y) const
{
    return at_pixel(SpreadLookup{}, r, x, y);
}
