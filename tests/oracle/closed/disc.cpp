#include "tests/oracle/closed/disc.h"

#include <cmath> // abs, sqrt

#include "tests/oracle/filters/poisson_disc.h" // POISSON_TAPS

static bool is_count(double visibility)
{
    double taps = visibility * POISSON_TAPS;
    return visibility >= 0 && visibility <= 1 && taps == std::floor(taps);
}

static bool is_mixed(double visibility)
{
    return visibility > 0 && visibility < 1;
}

void check_disc(const Run &disc, const Run &grid, Report &report)
{
    Receivers one(disc), other(grid);
    size_t broken = 0, mixed = 0;
    double difference = 0;
    for (int y = 0; y < disc.height; y++)
        for (int x = 0; x < disc.width; x++) {
            double a = one.at(x, y).visibility;
            double b = other.at(x, y).visibility;
            broken += is_count(a) ? 0 : 1;
            if (!is_mixed(a) && !is_mixed(b))
                continue;
            mixed++;
            difference += a - b;
        }
    report.line(broken == 0 && mixed > 0, "disc: counts of 32 taps",
                "%zu others, %zu pixels in penumbra", broken, mixed);
    double count = double(mixed > 0 ? mixed : 1);
    double most = 6 * 0.5 / std::sqrt(POISSON_TAPS * count);
    report.line(std::abs(difference) <= most * count,
                "disc: as light as the grid", "mean %.3g, at most %.3g",
                difference / count, most);
}
