#include <algorithm> // max, min
#include <cfloat>    // FLT_MIN
#include <cmath>     // abs

#include "tests/oracle/filters/chebyshev_bound.h" // resolve_share
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/stages/stage.h"

using Samples = std::vector<Picture>;

static double mean_at(const Samples &samples, int x, int y, int channel)
{
    double sum = 0;
    for (const Picture &sample : samples)
        sum += double(sample.at(x, y, channel));
    return sum / double(samples.size());
}

// M1 or M2: a mean.
static Interval raw_at(const Samples &samples, int x, int y, int channel,
                       const Settings &settings)
{
    double share = resolve_share(settings);
    return widened(rounded(mean_at(samples, x, y, channel), share),
                   resolve_absolute(settings) + FLT_MIN);
}

// With c the mean of the first sample and d how far the others are from it,
// from N rounded differences and sums each:
//     mean = c + s, s = sum d / N        s is off by (N + 2) u max|d|
//     variance = sum (v + d^2) / N - s^2 the first by (N + 4) u of itself, s^2
//                                        by 2 (N + 3) u max d^2
// and a sum each. Then both are stored.
static Interval central_at(const Samples &samples, int x, int y, int channel,
                           const Settings &settings)
{
    int n = int(samples.size());
    double first = double(samples[0].at(x, y)), farthest = 0, square = 0;
    for (const Picture &sample : samples) {
        double d = double(sample.at(x, y)) - first;
        farthest = std::max(farthest, std::abs(d));
        square += (double(sample.at(x, y, 1)) + d * d) / n;
    }
    double mean = mean_at(samples, x, y, 0);
    double shift = mean - first;
    double variance = square - shift * shift;
    double off = channel == 0
                     ? rounding_share(n + 2) * farthest
                     : rounding_share(n + 4) * square +
                           2 * rounding_share(n + 3) * farthest * farthest;
    Interval exact = widened(channel == 0 ? mean : variance, off);
    double share = UNIT_ROUNDOFF + 1.01 * store_share(settings);
    return widened(rounded(exact, share), store_absolute(settings) + FLT_MIN);
}

void check_resolve(const Run &run, int layer, Report &report)
{
    Picture map = load_map(run, layer);
    Samples samples = load_samples(run, layer);
    auto resolved = run.settings.central ? central_at : raw_at;
    size_t wrong = 0, mixed = 0;
    double worst = 0;
    for (int y = 0; y < map.height; y++)
        for (int x = 0; x < map.width; x++) {
            auto differs = [&](const Picture &sample) {
                return sample.at(x, y) != samples[0].at(x, y);
            };
            mixed += std::any_of(samples.begin(), samples.end(), differs);
            for (int channel = 0; channel < 2; channel++) {
                Interval truth = resolved(samples, x, y, channel, run.settings);
                double value = double(map.at(x, y, channel));
                wrong += truth.contains(value) ? 0 : 1;
                worst = std::max(worst, truth.distance(value));
            }
        }
    report.line(wrong == 0, "stage resolve: the moments of the samples",
                "%zu of %zu values off, worst by %.3g; in %zu texels the "
                "samples differ",
                wrong, map.values.size(), worst, mixed);
}
