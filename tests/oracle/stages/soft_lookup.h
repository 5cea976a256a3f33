// --soft: visibility in a penumbra of the receiver's own width, over intervals.
#ifndef ORACLE_SOFT_LOOKUP_H
#define ORACLE_SOFT_LOOKUP_H

#include <vector>

#include "tests/oracle/filters/chebyshev_bound.h"
#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/interval.h"

// What the soft-shadow post describes, with its taps where it meant them.
//
// A circle around the receiver, across the light's ray, is an ellipse in the
// map; the geometric mean of its axes counts as its width there. Widths are
// diameters.
//   search   light-size (t's distance - near), of a spot or point light over
//            near; from 4 texels up to an eighth of the map's side
//   areas    three: the search, 4 texels, and their geometric mean
//   M1, M2   of each one lookup at level log2(area / 2.6), less what the
//            receiver's own plane has for a variance over that,
//            (0.65 texels slope)^2, but at most 9 tenths of all
//   p        of each, the bound
//   t - z    sum (t - M1) / sum (1 - p), where t > M1; under 0.01 of 1 - p in
//            sum, the receiver is lit
//   penumbra penumbra-scale light-size (t's distance - z's), of a spot or point
//            light over z's; from 4 texels up to the search
//   taps     32 points of a disc of that width, at level log2(0.1407 of it)
//   hybrid   the same points; where the width is 4 texels, of half the distance
//            from z to t if that is less; each compares t on the receiver's own
//            plane, at the middle of the point's texel, less step 1's bias
class SoftLookup
{
  public:
    // Loads the levels, if the run is soft.
    SoftLookup(const Run &run, const Formula &formula);

    // Everything that 32-bit arithmetic may make of the visibility of a
    // receiver inside the map, which is pixel (x, y).
    Interval visibility(const Receiver &r, int x, int y) const;

  private:
    // E[t - X] and E[(t - X)^2] of depths X: sharper than M1 and M2, whose
    // errors go together.
    struct Before {
        Interval first, second;
    };
    struct Disc {
        bool lit, shaded;  // may be; both where rounding decides
        Interval width;    // texels
        Interval compared; // the same for the comparisons
    };

    struct Hidden {
        Interval before, share; // t - M1 and 1 - p
    };

    Before looked_up(const Receiver &r, double u, double v, double error,
                     Interval level) const;
    Bound bound_at(const Receiver &r, const Before &exact, Interval taken,
                   int taps) const;
    Hidden hidden(const Receiver &r, Interval area) const;
    Disc disc(const Receiver &r) const;
    Interval bounded(const Receiver &r, const Disc &disc, int x, int y) const;
    Interval compared(const Receiver &r, const Disc &disc, int x, int y) const;

    const Run &run_;
    const Formula &formula_;
    std::vector<std::vector<Picture>> levels_; // by layer
};

#endif
