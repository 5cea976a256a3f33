// --mips: the levels of a filtered map and the lookup in them, over intervals.
#ifndef ORACLE_MIP_LEVELS_H
#define ORACLE_MIP_LEVELS_H

#include <vector>

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/lib/verdict.h"
#include "tests/oracle/stages/spread.h"

// blurred.L.exr and blurred.L.mK.exr, K = 1, 2, ...: halved as long as both
// sides are even.
std::vector<Picture> load_levels(const Run &run, int layer);

class MipLookup
{
  public:
    explicit MipLookup(const Run &run);

    // Everything that 32-bit arithmetic may look up at a receiver, which is
    // pixel (x, y). Of the hardware's sampler: whatever a level up to one finer
    // or coarser gives, for that is how far its choices may be off.
    Interval moment(const Receiver &r, int x, int y, int channel) const;

    // The same of central moments, both at once.
    Spread spread(const Receiver &r, int x, int y) const;

  private:
    // By what is looked up: a Lookup knows how to look one level up, to blend
    // two, and to average.
    template <class Lookup>
    typename Lookup::Value at_level(const Lookup &lookup, const Receiver &r,
                                    double u, double v, double tap_error,
                                    double level) const;
    template <class Lookup>
    typename Lookup::Value along(const Lookup &lookup, const Receiver &r,
                                 const double direction[2], double longer,
                                 double shorter, int taps) const;
    template <class Lookup>
    typename Lookup::Value at_pixel(const Lookup &lookup, const Receiver &r,
                                    int x, int y) const;

    // Texels of the finest level that a lookup at a receiver may read to each
    // side, and how many level k reads.
    double free_;
    double reach(double level) const;

    int anisotropy_;
    bool hardware_;
    int radius_;
    Picture footprint_;
    std::vector<std::vector<Picture>> levels_; // by layer
};

// Each level from the one before: 1 3 3 1 over 8 along each axis, far depth
// outside; and what the level keeps of the mean.
void check_mips(const Run &run, int layer, Report &report);

// footprint.exr against the differences of u and v between neighbouring pixels
// that show the same flat surface.
void check_footprint(const Run &run, Report &report);

#endif
