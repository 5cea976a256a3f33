#include "tests/oracle/filters/footprint.h"

#include <cmath>   // exp, floor
#include <numeric> // accumulate

#include "tests/oracle/lib/rounding.h"

double position_error(double u, int size)
{
    // u * size is rounded, and so is the difference; twice that for drivers
    // that add the half texel elsewhere.
    return 4 * UNIT_ROUNDOFF * (std::abs(u) * size + 1);
}

static AxisFilter box_filter(int width, int before)
{
    return {before, std::vector<double>(size_t(width), 1.0 / width)};
}

static std::vector<AxisFilter> three_boxes(int radius)
{
    int texels = 2 * radius + 3, odd = 1;
    // The odd width whose third part of the texels is nearest.
    while (std::abs(3 * (odd + 2) - texels) < std::abs(3 * odd - texels))
        odd += 2;
    int other = (texels - odd) / 2;
    std::vector<AxisFilter> boxes;
    if (odd > 1)
        boxes.push_back(box_filter(odd, odd / 2));
    boxes.push_back(box_filter(other, (other - 1) / 2));
    boxes.push_back(box_filter(other, other / 2));
    return boxes;
}

static std::vector<double> single_weights(const Settings &settings)
{
    int radius = settings.radius;
    std::vector<double> weights(size_t(2 * radius) + 1, 1.0);
    if (settings.blur == Blur::BINOMIAL)
        weights = {1, 6, 15, 20, 15, 6, 1};
    if (settings.blur == Blur::GAUSSIAN && radius > 0)
        for (int i = -radius; i <= radius; i++) {
            double sigmas = 3.0 * i / radius;
            weights[size_t(i + radius)] = std::exp(-sigmas * sigmas / 2);
        }
    double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double &weight : weights)
        weight /= sum;
    return weights;
}

std::vector<AxisFilter> blur_filters(const Settings &settings)
{
    if (settings.radius == 0)
        return {};
    if (settings.blur == Blur::BOXES)
        return three_boxes(settings.radius);
    return {{settings.radius, single_weights(settings)}};
}

std::vector<double> blur_weights(const Settings &settings)
{
    std::vector<double> all = {1};
    for (const AxisFilter &filter : blur_filters(settings)) {
        std::vector<double> sum(all.size() + filter.weights.size() - 1, 0.0);
        for (size_t i = 0; i < all.size(); i++)
            for (size_t j = 0; j < filter.weights.size(); j++)
                sum[i + j] += all[i] * filter.weights[j];
        all = sum;
    }
    return all;
}

Footprint lookup_footprint(double u, double shift, int size,
                           const Settings &settings)
{
    int factor = settings.downsample;
    double x = u * (size / factor) - 0.5 + shift;
    double left = std::floor(x), w = x - left;
    std::vector<double> kernel = blur_weights(settings);
    size_t n = kernel.size();
    Footprint footprint;
    footprint.first = (int(left) - settings.radius) * factor;
    for (size_t i = 0; i <= n; i++) { // the left texel's kernel holds 0..n-1
        double weight =
            (i < n ? (1 - w) * kernel[i] : 0) + (i > 0 ? w * kernel[i - 1] : 0);
        for (int k = 0; k < factor; k++)
            footprint.weights.push_back(weight / factor);
    }
    return footprint;
}

Footprint tap_footprint(double u, double shift, int size,
                        const Settings &settings)
{
    int n = settings.kernel;
    double x = u * size + shift - (settings.bilinear ? 0.5 : 0);
    double left = std::floor(x), w = x - left;
    Footprint footprint{int(left) - (n - 1) / 2,
                        std::vector<double>(size_t(n), 1.0 / n)};
    if (settings.bilinear) {
        footprint.weights.front() = (1 - w) / n; // for n = 1 the only one
        footprint.weights.resize(size_t(n) + 1, w / n);
    }
    return footprint;
}

Footprint filter_footprint(int step, double u, int size,
                           const Settings &settings)
{
    return step <= 2 ? tap_footprint(u, 0, size, settings)
                     : lookup_footprint(u, 0, size, settings);
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
