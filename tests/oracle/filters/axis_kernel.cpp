#include "tests/oracle/filters/axis_kernel.h"

#include <algorithm> // lower_bound

#include "tests/oracle/filters/footprint.h" // blur_weights

static constexpr int CELLS = 256; // per texel

// Masses one cell apart, spread over a box by the trapezium rule.
static std::vector<double> boxed(const std::vector<double> &masses, int texels)
{
    size_t width = size_t(texels) * CELLS;
    std::vector<double> sums(masses.size() + 1, 0.0);
    for (size_t i = 0; i < masses.size(); i++)
        sums[i + 1] = sums[i] + masses[i];
    auto before = [&](size_t i) { return sums[std::min(i, masses.size())]; };
    std::vector<double> out(masses.size() + width);
    for (size_t i = 0; i < out.size(); i++) {
        size_t inner = i >= width ? i - width + 1 : 0;
        double whole = before(i) - before(inner); // all but the two ends
        double ends = before(i + 1) - before(i);
        if (i >= width)
            ends += before(i - width + 1) - before(i - width);
        out[i] = (whole + ends / 2) / double(width);
    }
    return out;
}

static std::vector<double> taps_of(int step, const Settings &settings)
{
    if (step <= 2)
        return {1};
    std::vector<double> weights = blur_weights(settings);
    std::vector<double> taps((weights.size() - 1) * CELLS + 1, 0.0);
    for (size_t i = 0; i < weights.size(); i++)
        taps[i * CELLS] = weights[i];
    return taps;
}

AxisKernel::AxisKernel(int step, const Settings &settings)
    : cell_(double(settings.downsample) / CELLS)
{
    std::vector<int> boxes = {settings.kernel};
    if (step == 2 && settings.bilinear)
        boxes.push_back(1);
    if (step >= 3)
        boxes = {1, 1, 1};
    std::vector<double> masses = taps_of(step, settings);
    for (int box : boxes)
        masses = boxed(masses, box);
    double sum = 0;
    for (double mass : masses)
        cumulative_.push_back(sum += mass);
    first_ = -0.5 * cell_ * double(masses.size());
}

double AxisKernel::quantile(double s) const
{
    s *= cumulative_.back();
    auto cell = std::lower_bound(cumulative_.begin(), cumulative_.end() - 1, s);
    double left = cell == cumulative_.begin() ? 0 : *(cell - 1);
    double part = *cell > left ? (s - left) / (*cell - left) : 0;
    return first_ + cell_ * (double(cell - cumulative_.begin()) + part);
}

double AxisKernel::half_width() const
{
    return -first_;
}
