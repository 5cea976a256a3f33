#include "tests/oracle/footprint.h"

#include <cmath> // floor

#include "tests/oracle/rounding.h"

double position_error(double u, int size)
{
    // u * size is rounded, and so is the difference; twice that for drivers
    // that add the half texel elsewhere.
    return 4 * UNIT_ROUNDOFF * (std::abs(u) * size + 1);
}

Footprint lookup_footprint(double u, double shift, int size, int factor,
                           int radius)
{
    double x = u * (size / factor) - 0.5 + shift;
    double left = std::floor(x), w = x - left;
    int n = 2 * radius + 1;
    Footprint footprint;
    footprint.first = (int(left) - radius) * factor;
    for (int i = 0; i <= n; i++) { // the box around the left texel holds 0..n-1
        double weight = (i < n ? 1 - w : 0) + (i > 0 ? w : 0);
        for (int k = 0; k < factor; k++)
            footprint.weights.push_back(weight / n / factor);
    }
    return footprint;
}

Footprint tap_footprint(double u, double shift, int size, int n)
{
    int centre = int(std::floor(u * size + shift));
    return {centre - (n - 1) / 2, std::vector<double>(size_t(n), 1.0 / n)};
}

static std::vector<double> axis_shifts(double u, int size)
{
    double x = u * size - 0.5, error = position_error(u, size);
    double kink = std::round(x) - x;
    if (std::abs(kink) < error)
        return {-error, kink, error};
    return {-error, error};
}

Shifts lookup_shifts(double u, double v, int width, int height)
{
    return {axis_shifts(u, width), axis_shifts(v, height)};
}
