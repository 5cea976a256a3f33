// What the program's own --min-variance auto adds to what it computed. Apart
// from stability_rows, since tests/stability has a Guard of its own.
#ifndef ORACLE_STABILITY_AUTO_H
#define ORACLE_STABILITY_AUTO_H

#include <functional>

#include "tests/oracle/dump/dump.h"

// The most that mean, variance and M2 can have come out as.
struct MostComputed {
    double mean, variance, m2;
};

// The p that a receiver then gets at most, but for the last roundings.
using MostWithAuto =
    std::function<double(const Receiver &, const MostComputed &)>;

MostWithAuto most_with_auto(const Run &run);

#endif
