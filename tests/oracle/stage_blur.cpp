#include <algorithm> // max
#include <cmath>     // abs

#include "tests/oracle/chebyshev_bound.h" // blur_share
#include "tests/oracle/footprint.h"       // blur_weights
#include "tests/oracle/stage.h"

namespace
{

// One moment of a map in double; outside it is 1, the far depth.
struct Channel {
    int width, height;
    std::vector<double> values;

    Channel(int w, int h) : width(w), height(h), values(size_t(w) * size_t(h))
    {
    }
    double &at(int x, int y)
    {
        return values[size_t(y) * size_t(width) + size_t(x)];
    }
    double at(int x, int y) const
    {
        bool holds = x >= 0 && y >= 0 && x < width && y < height;
        return holds ? values[size_t(y) * size_t(width) + size_t(x)] : 1;
    }
};

} // namespace

static Channel downsampled(const Picture &map, int channel, int factor)
{
    Channel small(map.width / factor, map.height / factor);
    for (int y = 0; y < small.height * factor; y++)
        for (int x = 0; x < small.width * factor; x++)
            small.at(x / factor, y / factor) +=
                double(map.at(x, y, channel)) / (factor * factor);
    return small;
}

// One axis. Sums in double, so that their order does not matter.
static Channel blurred_along(const Channel &in,
                             const std::vector<double> &weights, int step_x,
                             int step_y)
{
    Channel out(in.width, in.height);
    int radius = int(weights.size() - 1) / 2;
    for (int y = 0; y < in.height; y++)
        for (int x = 0; x < in.width; x++) {
            double sum = 0;
            for (int i = -radius; i <= radius; i++)
                sum += weights[size_t(i + radius)] *
                       in.at(x + i * step_x, y + i * step_y);
            out.at(x, y) = sum;
        }
    return out;
}

static void compare(const Picture &blurred, int channel, const Channel &truth,
                    const Settings &settings, Report &report)
{
    double share = blur_share(settings);
    double tiny = blur_absolute(settings) + 1e-15;
    size_t wrong = 0;
    double worst = 0;
    for (int y = 0; y < truth.height; y++)
        for (int x = 0; x < truth.width; x++) {
            double value = blurred.at(x, y, channel);
            double error = std::abs(value - truth.at(x, y));
            worst = std::max(worst, error);
            wrong += error <= share * truth.at(x, y) + tiny ? 0 : 1;
        }
    report.line(wrong == 0, "stage blur: M" + std::to_string(channel + 1),
                "%zu of %zu texels outside, worst %.3g, bound %.3g relative",
                wrong, truth.values.size(), worst, share);
}

// The weight of a kernel around texel i that stays inside an axis of n texels.
static double kept(int i, int n, const std::vector<double> &weights)
{
    int radius = int(weights.size() - 1) / 2;
    double inside = 0;
    for (int k = std::max(-radius, -i); k <= std::min(radius, n - 1 - i); k++)
        inside += weights[size_t(k + radius)];
    return inside;
}

// A kernel of weight 1 keeps the sum of 1 - M (0 outside the map) except for
// what leaves over the map's edge, known texel by texel without blurring.
static void compare_mean(const Picture &blurred, int channel,
                         const Channel &small, const Settings &settings,
                         Report &report)
{
    std::vector<double> weights = blur_weights(settings);
    double share = blur_share(settings);
    double before = 0, expected = 0, after = 0, texels = 0;
    for (int y = 0; y < small.height; y++)
        for (int x = 0; x < small.width; x++) {
            double nearness = 1 - small.at(x, y);
            before += nearness;
            expected += nearness * kept(x, small.width, weights) *
                        kept(y, small.height, weights);
            after += 1 - double(blurred.at(x, y, channel));
            texels += 1;
        }
    double error = std::abs(after - expected) / texels;
    double bound =
        share * (1 - expected / texels) + blur_absolute(settings) + 1e-12;
    report.line(error <= bound,
                "stage blur keeps the mean: M" + std::to_string(channel + 1),
                "mean of 1 - M %.6g, off by %.3g, bound %.3g, left over the "
                "edge %.3g",
                after / texels, error, bound, (before - expected) / texels);
}

void check_blur(const Run &run, int layer, Report &report)
{
    Picture moments = load_map(run, layer);
    Picture blurred = load_filtered(run, layer);
    const Settings &settings = run.settings;
    std::vector<double> weights = blur_weights(settings);
    if (!settings.sat) // a table's box is never stored
        check_stored(blurred, settings, "blurred", report);
    for (int channel = 0; channel < 2; channel++) {
        Channel small = downsampled(moments, channel, settings.downsample);
        Channel across = blurred_along(small, weights, 1, 0);
        Channel truth = blurred_along(across, weights, 0, 1);
        compare(blurred, channel, truth, settings, report);
        compare_mean(blurred, channel, small, settings, report);
    }
}
