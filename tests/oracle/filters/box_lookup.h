// --sat-width adaptive: the mean of the moments over a box whose width is the
// pixel's own, over intervals.
#ifndef ORACLE_BOX_LOOKUP_H
#define ORACLE_BOX_LOOKUP_H

#include <array>
#include <vector>

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/interval.h"

class BoxLookup
{
  public:
    // Sums moments.L.exr; where the run has no such box, does nothing.
    explicit BoxLookup(const Run &run);

    // Everything that 32-bit arithmetic and a table of 32-bit integers may make
    // of M1 (channel 0) or M2 around a receiver, which is pixel (x, y).
    Interval moment(const Receiver &r, int x, int y, int channel) const;

    // The box's width at a pixel, in texels.
    Interval width(const Receiver &r, int x, int y) const;

  private:
    // sums[y * (width + 1) + x]: of 1 - M over all texels left of x and below
    // y.
    struct Sums {
        int width, height;
        std::vector<double> sums;
        double until(double x, double y) const;
        double mean(double x, double y, double width) const;
    };
    static Sums sums_of(const Picture &map, int channel, int factor);

    Settings settings_;
    Picture footprint_;
    std::vector<std::array<Sums, 2>> layers_;
};

#endif
