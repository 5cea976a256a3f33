// The weights with which a filter sees the texels of the map, along one axis.
// Every filter here is separable: a texel's weight is the product of two.
#ifndef ORACLE_FOOTPRINT_H
#define ORACLE_FOOTPRINT_H

#include <vector>

#include "tests/oracle/dump.h"

struct Footprint {
    int first; // texel of weights[0]; may lie outside the map
    std::vector<double> weights;
};

// The half-width, in texels, of the positions that u * size - 0.5 can have
// become in 32-bit arithmetic.
double position_error(double u, int size);

// Bilinear lookup at u of a map of `size` texels (before downsampling by
// `factor`) blurred by a box of 2 radius + 1 downsampled texels; `shift`
// moves the position, in downsampled texels.
Footprint lookup_footprint(double u, double shift, int size, int factor,
                           int radius);

// The n texels around floor(u * size), n odd, equal weights.
Footprint tap_footprint(double u, double shift, int size, int n);

// The positions that enclose everything that rounding can make of one: the two
// ends along each axis, and a texel centre between them, where the weights
// have a kink.
struct Shifts {
    std::vector<double> x, y;
};
Shifts lookup_shifts(double u, double v, int width, int height);

#endif
