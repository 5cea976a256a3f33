// What rounding does to a mean and a variance on their way from the map to the
// bound, and what --min-variance auto adds against it: the formulas that
// step5_chebyshev/techniques/guard/proof.md derives, in double.
#ifndef ORACLE_GUARD_H
#define ORACLE_GUARD_H

#include <vector>

#include "tests/oracle/dump/dump.h"

// One of the averages in a row.
struct MergePass {
    double taps;     // products and sums that a term meets
    double heaviest; // the largest weight
    double defect;   // of the weights' sum
    bool stored;
    bool two; // between two texels, along one axis
};

// Downsampling and the blur's axes.
std::vector<MergePass> filter_passes(const Settings &settings);

// Of central moments, whatever the depths.
struct CentralErrors {
    double spread = 0; // of the standard deviation, in parts of it
    double moved = 0;  // by the means before the last pass, in parts of M
    double mean = 0;   // of the mean, in parts of M; and the spread of it
    double tiny = 0;   // of underflow, in variance and mean
};
CentralErrors central_errors(const std::vector<MergePass> &passes,
                             const Settings &settings);

// The part of a number M that rounding moves by u times it: from 1/2 to 1 all
// floats are equally far apart.
double rounded_part(double m);

struct Guard {
    bool promises = true; // no second order that counts
    double spread = 0;    // central
    double variance = 0, variance_fixed = 0;
    double mean = 0, mean_fixed = 0;
};
Guard guard_of(const Run &run);

#endif
