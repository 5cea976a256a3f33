#include <algorithm> // max
#include <cmath>     // abs

#include "tests/oracle/filters/chebyshev_bound.h" // blur_share
#include "tests/oracle/filters/footprint.h"       // blur_filters
#include "tests/oracle/stages/guard.h"            // central_errors
#include "tests/oracle/stages/stage.h"

namespace
{

// One moment of a map in double; outside it is 1, the far depth. Of central
// moments too: their M2 is V + M1^2.
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

static double moment_of(const Picture &map, int x, int y, int channel,
                        bool central)
{
    double mean = map.at(x, y, 0), value = map.at(x, y, channel);
    return central && channel == 1 ? value + mean * mean : value;
}

static Channel downsampled(const Picture &map, int channel,
                           const Settings &settings)
{
    int factor = settings.downsample;
    Channel small(map.width / factor, map.height / factor);
    for (int y = 0; y < small.height * factor; y++)
        for (int x = 0; x < small.width * factor; x++)
            small.at(x / factor, y / factor) +=
                moment_of(map, x, y, channel, settings.central) /
                (factor * factor);
    return small;
}

// One axis. Sums in double, so that their order does not matter.
static Channel filtered_along(const Channel &in, const AxisFilter &filter,
                              int step_x, int step_y)
{
    Channel out(in.width, in.height);
    for (int y = 0; y < in.height; y++)
        for (int x = 0; x < in.width; x++) {
            double sum = 0;
            for (size_t k = 0; k < filter.weights.size(); k++) {
                int i = int(k) - filter.before;
                sum +=
                    filter.weights[k] * in.at(x + i * step_x, y + i * step_y);
            }
            out.at(x, y) = sum;
        }
    return out;
}

// All filters along u, then all along v. Each of them reads far depth outside.
static Channel blurred(const Channel &in, const Settings &settings)
{
    Channel out = in;
    for (int axis = 0; axis < 2; axis++)
        for (const AxisFilter &filter : blur_filters(settings))
            out = filtered_along(out, filter, 1 - axis, axis);
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

// --moments central: the mean and the standard deviation, see guard.h.
static void compare_central(const Picture &blurred, const Channel &m1,
                            const Channel &m2, const Settings &settings,
                            Report &report)
{
    CentralErrors e = central_errors(filter_passes(settings), settings);
    size_t wrong_mean = 0, wrong_deviation = 0;
    double worst_mean = 0, worst_deviation = 0;
    for (int y = 0; y < m1.height; y++)
        for (int x = 0; x < m1.width; x++) {
            double mean = m1.at(x, y), square = m2.at(x, y);
            // The oracle's own difference, in double.
            double deviation = std::sqrt(std::max(square - mean * mean, 0.0));
            double own = std::sqrt(1e-15), tiny = std::sqrt(e.tiny);
            double mean_error = std::abs(blurred.at(x, y, 0) - mean);
            double error =
                std::abs(std::sqrt(double(blurred.at(x, y, 1))) - deviation);
            wrong_mean += mean_error <= e.mean * rounded_part(mean) +
                                            e.spread * deviation + e.tiny
                              ? 0
                              : 1;
            wrong_deviation +=
                error <= e.spread * deviation +
                             e.moved * rounded_part(std::sqrt(square)) + own +
                             tiny
                    ? 0
                    : 1;
            worst_mean = std::max(worst_mean, mean_error);
            worst_deviation = std::max(worst_deviation, error);
        }
    report.line(wrong_mean == 0, "stage blur: mean",
                "%zu of %zu texels outside, worst %.3g", wrong_mean,
                m1.values.size(), worst_mean);
    report.line(wrong_deviation == 0, "stage blur: deviation",
                "%zu of %zu texels outside, worst %.3g, bound %.3g of it and "
                "%.3g of M",
                wrong_deviation, m1.values.size(), worst_deviation, e.spread,
                e.moved);
}

// How much of each texel the filters keep inside an axis of n texels: the
// last one spreads it over what is there, and so on back to the first.
static std::vector<double> kept(int n, const Settings &settings)
{
    std::vector<double> parts(size_t(n), 1.0);
    std::vector<AxisFilter> filters = blur_filters(settings);
    for (auto filter = filters.rbegin(); filter != filters.rend(); ++filter) {
        std::vector<double> before(size_t(n), 0.0);
        for (int x = 0; x < n; x++)
            for (size_t k = 0; k < filter->weights.size(); k++) {
                int i = x + int(k) - filter->before;
                if (i >= 0 && i < n)
                    before[size_t(i)] += filter->weights[k] * parts[size_t(x)];
            }
        parts = before;
    }
    return parts;
}

// A kernel of weight 1 keeps the sum of 1 - M (0 outside the map) except for
// what leaves over the map's edge, known texel by texel without blurring.
static void compare_mean(const Picture &blurred, int channel,
                         const Channel &small, const Settings &settings,
                         Report &report)
{
    std::vector<double> columns = kept(small.width, settings);
    std::vector<double> rows = kept(small.height, settings);
    double share = blur_share(settings);
    double before = 0, expected = 0, after = 0, texels = 0;
    for (int y = 0; y < small.height; y++)
        for (int x = 0; x < small.width; x++) {
            double nearness = 1 - small.at(x, y);
            before += nearness;
            expected += nearness * columns[size_t(x)] * rows[size_t(y)];
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
    Picture filtered = load_filtered(run, layer);
    const Settings &settings = run.settings;
    if (!settings.sat) // a table's box is never stored
        check_stored(filtered, settings, "blurred", report);
    std::vector<Channel> truths;
    for (int channel = 0; channel < 2; channel++) {
        Channel small = downsampled(moments, channel, settings);
        truths.push_back(blurred(small, settings));
        if (!settings.central)
            compare(filtered, channel, truths[size_t(channel)], settings,
                    report);
        if (!settings.central || channel == 0)
            compare_mean(filtered, channel, small, settings, report);
    }
    if (settings.central)
        compare_central(filtered, truths[0], truths[1], settings, report);
}
