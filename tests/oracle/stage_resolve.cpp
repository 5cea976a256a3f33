#include <algorithm> // max
#include <cfloat>    // FLT_MIN

#include "tests/oracle/chebyshev_bound.h" // resolve_share
#include "tests/oracle/stage.h"

void check_resolve(const Run &run, int layer, Report &report)
{
    Picture map = load_map(run, layer);
    std::vector<Picture> samples = load_samples(run, layer);
    const Settings &settings = run.settings;
    double share = resolve_share(settings), worst = 0;
    double tiny = resolve_absolute(settings) + FLT_MIN;
    size_t wrong = 0, mixed = 0;
    for (size_t i = 0; i < map.values.size(); i++) {
        double sum = 0;
        bool same = true;
        for (const Picture &sample : samples) {
            sum += double(sample.values[i]);
            same = same && sample.values[i] == samples[0].values[i];
        }
        double mean = sum / double(samples.size());
        double error = std::abs(double(map.values[i]) - mean);
        mixed += same ? 0 : 1;
        wrong += error <= share * mean + tiny ? 0 : 1;
        worst = std::max(worst, error);
    }
    report.line(wrong == 0, "stage resolve: the mean of the samples",
                "%zu of %zu values off, worst by %.3g; of %zu the samples "
                "differ",
                wrong, map.values.size(), worst, mixed);
}
