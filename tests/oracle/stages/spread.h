// Mean and variance of depths, over intervals, and their merging: of central
// moments, where a variance is no weighted mean of variances.
#ifndef ORACLE_SPREAD_H
#define ORACLE_SPREAD_H

#include <utility> // pair
#include <vector>

#include "tests/oracle/lib/interval.h"
#include "tests/oracle/lib/picture.h"

struct Spread {
    Interval mean, variance;
};

// A texel of a central map; far depth outside of it.
Spread spread_at(const Picture &map, int x, int y);

// Of weights that add up to 1: variances, and what the means vary by. Nothing
// cancels.
Spread merged(const std::vector<std::pair<double, Spread>> &parts);

Spread hull(const Spread &a, const Spread &b);

// Between 2 x 2 texels; x and y in texels, whole numbers at their middle.
Spread bilinear_spread(const Picture &map, double x, double y);

// The same at every place that is off by these shifts, as 32-bit arithmetic
// has it.
Spread looked_up_spread(const Picture &map, double x, double y,
                        const std::vector<double> &shifts_x,
                        const std::vector<double> &shifts_y);

// As 32-bit arithmetic has what is between two of them.
Spread rounded_once(const Spread &exact);

#endif
