// The rows of the check `stability`.
#ifndef ORACLE_STABILITY_ROWS_H
#define ORACLE_STABILITY_ROWS_H

#include <string>

#include "tests/oracle/dump/dump.h"

struct StabilityRow {
    std::string quantity;
    size_t compared = 0, all = 0;
    double error = 0, bound = 0, ratio = 0;
    double searched = -1; // below 0: no search
    double below = 0;
    double open_error = 0, open_bound = 0; // of what has no promise

    // An error and its bound; whether it is the largest part so far.
    bool add(double found, double most)
    {
        compared++;
        double part = most > 0 ? found / most : found > 0 ? INFINITY : 0;
        if (part <= ratio && compared > 1) // false for NaN
            return false;
        ratio = part;
        error = found;
        bound = most;
        return true;
    }
};

// Steps 3 to 5, whose bounds are those of tests/stability/bound.h.
StabilityRow variance_row(const Run &run);
StabilityRow p_row(const Run &run);

#endif
