#include <algorithm> // max
#include <cmath>     // abs

#include "tests/oracle/filters/chebyshev_bound.h" // store_share
#include "tests/oracle/stages/guard.h"            // central_errors
#include "tests/oracle/filters/mip_levels.h"
#include "tests/oracle/lib/rounding.h"

static double texel(const Picture &map, int x, int y, int channel)
{
    return map.holds(x, y) ? double(map.at(x, y, channel)) : 1.0;
}

// 4 x 4 texels, the middle four of them below texel (x, y) of the next level.
static double reduced(const Picture &fine, int x, int y, int channel)
{
    static const int weights[] = {1, 3, 3, 1};
    double sum = 0;
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++)
            sum += weights[i] * weights[j] *
                   texel(fine, 2 * x - 1 + i, 2 * y - 1 + j, channel);
    return sum / 64;
}

static void check_level(const Picture &fine, const Picture &coarse,
                        size_t level, int channel, const Settings &settings,
                        Report &report)
{
    // 16 products whose weights are exact, 16 sums; all positive.
    double share = (1 + rounding_share(32)) * (1 + store_share(settings)) - 1;
    double tiny = store_absolute(settings) + 1e-15;
    size_t wrong = 0;
    double worst = 0, before = 0, after = 0;
    for (int y = 0; y < coarse.height; y++)
        for (int x = 0; x < coarse.width; x++) {
            double truth = reduced(fine, x, y, channel);
            double error = std::abs(coarse.at(x, y, channel) - truth);
            worst = std::max(worst, error);
            wrong += error <= share * truth + tiny ? 0 : 1;
            after += 1 - double(coarse.at(x, y, channel));
        }
    // Outside is 0 in 1 - M, and an edge texel gives a quarter of itself away.
    for (int y = 0; y < fine.height; y++)
        for (int x = 0; x < fine.width; x++) {
            bool side = x == 0 || x == fine.width - 1;
            bool end = y == 0 || y == fine.height - 1;
            before += (1 - double(fine.at(x, y, channel))) * (side ? 0.75 : 1) *
                      (end ? 0.75 : 1) / 4;
        }
    double texels = double(coarse.width) * coarse.height;
    std::string name = "M" + std::to_string(channel + 1) + " of level " +
                       std::to_string(level);
    report.line(wrong == 0, "stage mips: " + name,
                "%zu of %.0f texels outside, worst %.3g, bound %.3g relative",
                wrong, texels, worst, share);
    double error = std::abs(after - before) / texels;
    report.line(error <= share + tiny, "stage mips keeps the mean: " + name,
                "mean of 1 - M %.6g, off by %.3g, bound %.3g", after / texels,
                error, share + tiny);
}

// --moments central: one merge of 16 taps, see guard.h.
static void check_central_level(const Picture &fine, const Picture &coarse,
                                size_t level, const Settings &settings,
                                Report &report)
{
    CentralErrors e =
        central_errors({{16, 9.0 / 64, 0, true, false}}, settings);
    static const int weights[] = {1, 3, 3, 1};
    size_t wrong = 0;
    double worst = 0;
    for (int y = 0; y < coarse.height; y++)
        for (int x = 0; x < coarse.width; x++) {
            std::vector<std::pair<double, Spread>> parts;
            for (int j = 0; j < 4; j++)
                for (int i = 0; i < 4; i++)
                    parts.push_back(
                        {weights[i] * weights[j] / 64.0,
                         spread_at(fine, 2 * x - 1 + i, 2 * y - 1 + j)});
            Spread all = merged(parts);
            double mean = all.mean.lo, variance = all.variance.lo;
            double deviation = std::sqrt(variance);
            double off = std::abs(double(coarse.at(x, y, 0)) - mean);
            double error = std::abs(double(coarse.at(x, y, 1)) - variance);
            bool good = off <= e.mean * rounded_part(mean) +
                                   e.spread * deviation + e.tiny &&
                        error <= 2 * e.spread * variance + e.tiny + 1e-16;
            wrong += good ? 0 : 1;
            worst = std::max({worst, off, error});
        }
    report.line(wrong == 0,
                "stage mips: mean and variance of level " +
                    std::to_string(level),
                "%zu of %d texels outside, worst %.3g, bound %.3g relative",
                wrong, coarse.width * coarse.height, worst, 2 * e.spread);
}

void check_mips(const Run &run, int layer, Report &report)
{
    std::vector<Picture> levels = load_levels(run, layer);
    for (size_t k = 1; k < levels.size(); k++) {
        const Picture &fine = levels[k - 1], &coarse = levels[k];
        if (run.settings.central) {
            check_central_level(fine, coarse, k, run.settings, report);
            continue;
        }
        for (int channel = 0; channel < 2; channel++)
            check_level(fine, coarse, k, channel, run.settings, report);
    }
}

// The share of neighbours, in blocks of 2 x 2 pixels, whose u or v differs by
// what the footprint says. On curved surfaces the two differ, and at outlines.
static double agreeing(const Run &run, const Picture &footprint, int along_x,
                       int along_y, int axis)
{
    Receivers receivers(run);
    size_t pairs = 0, agree = 0;
    for (int y = 0; y + 1 < run.height; y += 2)
        for (int x = 0; x + 1 < run.width; x += 2) {
            Receiver here = receivers.at(x, y);
            Receiver next = receivers.at(x + along_x, y + along_y);
            if (!here.shown || here.layer != next.layer ||
                glm::distance(here.normal, next.normal) > 1e-3)
                continue;
            // The footprint is a differential; over a whole pixel a quotient
            // by w, of a perspective, changes by w / w' as much.
            const glm::dvec4 &w = run.views[size_t(here.layer)].rows[3];
            double step = axis == 0 ? next.u - here.u : next.v - here.v;
            step *= glm::dot(w, glm::dvec4(next.position, 1)) /
                    glm::dot(w, glm::dvec4(here.position, 1));
            double said = footprint.at(x, y, axis + 2 * along_y);
            pairs++;
            agree += std::abs(step - said) <= 0.02 * std::abs(said) + 1e-6;
        }
    return pairs == 0 ? 1 : double(agree) / double(pairs);
}

void check_footprint(const Run &run, Report &report)
{
    Picture footprint =
        load_file(run, "footprint.exr", run.width, run.height, 4);
    for (int axis = 0; axis < 2; axis++)
        for (int up = 0; up < 2; up++) {
            double share = agreeing(run, footprint, 1 - up, up, axis);
            report.line(
                share >= 0.95,
                std::string("footprint: d") + "uv"[axis] + "/d" + "xy"[up],
                "%.2f %% of flat neighbours differ by that", 100 * share);
        }
}
