// The weights with which a filter sees the texels of the map, along one axis.
// Every filter here is separable: a texel's weight is the product of two.
#ifndef ORACLE_FOOTPRINT_H
#define ORACLE_FOOTPRINT_H

#include <vector>

#include "tests/oracle/dump/dump.h"

struct Footprint {
    int first; // texel of weights[0]; may lie outside the map
    std::vector<double> weights;
};

// The half-width, in texels, of the positions that u * size - 0.5 can have
// become in 32-bit arithmetic.
double position_error(double u, int size);

// One of the filters that a blur runs one after the other along an axis.
struct AxisFilter {
    int before;                  // texels before the one it is the mean around
    std::vector<double> weights; // their sum is 1
};

// All of them; none without a radius. The only place that knows the kernels:
// - box: all weights the same,
// - boxes: three of those, of 2 radius + 3 texels together and as alike in
//   width as can be where one is odd and the others are the same; one of even
//   width is half a texel off, the next one half a texel the other way,
// - gaussian: exp(-i^2 / (2 s^2)) with s = radius / 3,
// - binomial: 1 6 15 20 15 6 1.
std::vector<AxisFilter> blur_filters(const Settings &settings);

// What they make together: 2 radius + 1 weights.
std::vector<double> blur_weights(const Settings &settings);

// Bilinear lookup at u of a map of `size` texels (before downsampling),
// downsampled and blurred; `shift` moves the position, in downsampled texels.
Footprint lookup_footprint(double u, double shift, int size,
                           const Settings &settings);

// The comparisons of steps 1 and 2: the n texels around floor(u * size), equal
// weights. Bilinear: n lookups at u * size plus whole texels, so n + 1 texels
// of which the first and the last share one weight.
Footprint tap_footprint(double u, double shift, int size,
                        const Settings &settings);

// The whole filter of a step.
Footprint filter_footprint(int step, double u, int size,
                           const Settings &settings);

// The positions that enclose everything that rounding can make of one: the two
// ends along each axis, and a texel centre between them, where the weights
// have a kink.
struct Shifts {
    std::vector<double> x, y;
};
Shifts lookup_shifts(double u, double v, int width, int height);

#endif
