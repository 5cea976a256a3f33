#include <algorithm> // max
#include <cfloat>    // FLT_MIN
#include <cmath>     // nextafter, frexp, fmod

#include "tests/oracle/filters/chebyshev_bound.h" // store_share
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/stages/stage.h"

// Within one unit in the last place: some compilers fuse or reorder. Squares
// under FLT_MIN may be flushed to 0.
static bool is_square(float m1, float m2)
{
    float square = m1 * m1;
    float below = std::nextafter(square, -1.0f);
    float above = std::nextafter(square, 2.0f * square + 1.0f);
    return (below <= m2 && m2 <= above) || std::abs(m2 - square) <= FLT_MIN;
}

// M2 is the square of a depth that became M1; both were rounded when stored.
static bool is_stored_square(float m1, float m2, const Settings &settings)
{
    double share = store_share(settings), tiny = store_absolute(settings);
    Interval depth = widened(Interval(m1) / Interval(1 - share, 1 + share),
                             tiny / (1 - share));
    Interval stored = rounded(square(depth), share + UNIT_ROUNDOFF);
    return widened(stored, tiny).contains(m2);
}

static bool is_half(float value)
{
    if (!std::isfinite(value))
        return false; // no depth and no square of one is that
    int exponent;
    std::frexp(value, &exponent); // value = 0.5..1 * 2^exponent
    double unit = std::ldexp(1.0, std::max(exponent - 11, -24));
    return std::fmod(value, unit) == 0;
}

void check_stored(const Picture &map, const Settings &settings,
                  const std::string &name, Report &report)
{
    if (!settings.half)
        return;
    size_t wrong = 0, full = 0;
    for (float value : map.values) {
        wrong += is_half(value) ? 0 : 1;
        full += value == 1 ? 1 : 0;
    }
    report.line(wrong == 0, "stage " + name + ": 16-bit floats",
                "%zu of %zu values are not, %zu are 1", wrong,
                map.values.size(), full);
}

// --moments central: one depth does not vary. With --slope-term it does, by no
// more than depths in [0, 1] can: E[x^2] is at most E[x].
static void check_central(const Picture &moments, const Settings &settings,
                          Report &report)
{
    size_t wrong = 0;
    double worst = 0;
    for (int y = 0; y < moments.height; y++)
        for (int x = 0; x < moments.width; x++) {
            double mean = moments.at(x, y, 0), variance = moments.at(x, y, 1);
            double most = settings.slope_term ? mean - mean * mean : 0;
            double share = store_share(settings) + rounding_share(2);
            most += share + store_absolute(settings);
            most = settings.slope_term ? most : 0;
            wrong += variance >= 0 && variance <= most ? 0 : 1;
            worst = std::max(worst, variance);
        }
    report.line(wrong == 0,
                settings.slope_term
                    ? "stage moments: the variance is one of depths in [0, 1]"
                    : "stage moments: the variance is 0",
                "not so in %zu texels, the largest is %.3g", wrong, worst);
}

// One depth per texel.
static void check_depths(const Picture &moments, const Settings &settings,
                         Report &report)
{
    size_t wrong = 0;
    double worst = 0;
    for (int y = 0; y < moments.height; y++)
        for (int x = 0; x < moments.width; x++) {
            float m1 = moments.at(x, y, 0), m2 = moments.at(x, y, 1);
            if (settings.slope_term) { // see check_slope
                wrong += m2 <= m1 ? 0 : 1;
                continue;
            }
            bool good = settings.half ? is_stored_square(m1, m2, settings)
                                      : is_square(m1, m2);
            wrong += good ? 0 : 1;
            worst = std::max(worst, std::abs(double(m2) - double(m1) * m1));
        }
    report.line(
        wrong == 0,
        settings.slope_term ? "stage moments: M2 is at most M1"
                            : "stage moments: M2 is M1 squared",
        "%zu texels off by more than the rounding, worst |M2 - M1^2| %.3g",
        wrong, worst);
}

void check_moments(const Run &run, int layer, Report &report)
{
    check_stored(load_map(run, layer), run.settings, "moments", report);
    for (const Picture &sample : load_samples(run, layer))
        if (run.settings.central)
            check_central(sample, run.settings, report);
        else
            check_depths(sample, run.settings, report);
}
