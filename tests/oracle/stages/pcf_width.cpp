#include "tests/oracle/stages/pcf_width.h"

#include <algorithm> // max, min
#include <cmath>     // ceil, hypot

// Of the longer axis: some ten operations in floats.
static constexpr double AXIS_ERROR = 4e-6;
static constexpr int LEAST_WIDTH = 3;

PcfWidth::PcfWidth(const Run &run) : kernel_(run.settings.kernel)
{
    if (run.settings.adaptive)
        footprint_ = load_file(run, "footprint.exr", run.width, run.height, 4);
}

// The larger singular value of (a b; c d).
static double norm(double a, double b, double c, double d)
{
    return (std::hypot(a + d, b - c) + std::hypot(a - d, b + c)) / 2;
}

std::vector<int> PcfWidth::at(const Receiver &r, int x, int y, int map_width,
                              int map_height) const
{
    if (footprint_.values.empty())
        return {kernel_};
    double wide = r.footprint_scale * map_width;
    double high = r.footprint_scale * map_height;
    double texels =
        norm(footprint_.at(x, y, 0) * wide, footprint_.at(x, y, 2) * wide,
             footprint_.at(x, y, 1) * high, footprint_.at(x, y, 3) * high);
    auto width = [&](double share) {
        double over = std::max(share * texels - LEAST_WIDTH, 0.0);
        double steps = std::ceil(std::min(over, 1e6) / 2);
        return std::min(LEAST_WIDTH + 2 * int(steps), kernel_);
    };
    int narrow = width(1 - AXIS_ERROR), broad = width(1 + AXIS_ERROR);
    return narrow == broad ? std::vector<int>{narrow}
                           : std::vector<int>{narrow, broad};
}
