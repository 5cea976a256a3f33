// The moments about a receiver's depth between texels and levels, over
// intervals of the place and the level.
#ifndef ORACLE_DEPTH_LOOKUP_H
#define ORACLE_DEPTH_LOOKUP_H

#include <vector>

#include "tests/oracle/lib/interval.h"
#include "tests/oracle/lib/picture.h"

// What is averaged over a texel's depths X: t - X, or (t - X)^2.
struct Average {
    double t;
    bool squared;
    bool central; // a texel holds mean and variance, not M1 and M2

    double operator()(double first, double second) const;
};

// The trilinear mean at (u, v), each give or take `error` and what 32-bit
// arithmetic makes of a place; the lookup's own rounding is left out.
Interval between_levels(const std::vector<Picture> &levels, double u, double v,
                        double error, Interval level, const Average &of);

#endif
