// Step 5's formula over intervals.
#ifndef ORACLE_CHEBYSHEV_BOUND_H
#define ORACLE_CHEBYSHEV_BOUND_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/stages/guard.h"
#include "tests/oracle/lib/interval.h"

// What a lookup finds: M1 and M2, or mean and variance.
struct Moments {
    Interval m1, second;
};

// The settings of a run, and what follows from them.
struct Formula {
    Settings settings;
    Guard guard;

    explicit Formula(const Run &run)
        : settings(run.settings), guard(guard_of(run))
    {
    }
};

// The deviation that --min-variance auto gives a receiver's own depth where
// moments are central: 64 units of the part of t that its distance from the
// camera makes.
double depth_noise(const MapView &view, const glm::dvec3 &position);

// Every visibility that 32-bit arithmetic may make of moments and a receiver at
// depth t with this noise: Cantelli's p_max with the minimum variance and the
// light-bleeding reduction of the settings.
Interval chebyshev(const Moments &moments, Interval t, double noise,
                   const Formula &formula);

// The bound itself, and what it was made of: t - M1 (`before`) and the variance
// where they are known more sharply than from the moments, as of taps whose
// errors go together. Neither is reduced.
struct Bound {
    Interval before; // what --min-variance auto leaves of it
    Interval p;
};
Bound bound_of(const Moments &moments, Interval before, Interval variance,
               double noise, const Formula &formula);

// What the light-bleeding reduction makes of it.
Interval reduced(Interval p, const Settings &settings);

// The same without rounding, of a mean and a variance; the minimum variance
// included.
double chebyshev_exact(double m1, double variance, double t, double noise,
                       const Formula &formula);

// The relative error of the blurred moments against the exact weighted sum of
// the map's: f^2 + 1 operations for the mean of f x f texels, n + 1 for a row
// of the box and as many for a column (n products, n - 1 sums, the rounded
// weight). All terms are positive, so it is relative. 0 where nothing is done.
// Each pass also stores its result, see store_share.
double blur_share(const Settings &settings);

// The same below 2^-14, where 16-bit floats have a fixed step.
double blur_absolute(const Settings &settings);

// The same of a summed-area table: the integers that sum the texels of the box
// must not exceed 32 bits, so a texel is rounded to a power of two of at most
// 2^32 / n^2 steps, and a few floats of up to 1 are blended. 0 without one.
double table_absolute(const Settings &settings);

// What storing a moment may change. A 32-bit float: nothing, for it was one.
// A 16-bit float: a whole unit of 2^-10, since some drivers truncate, and
// 2^-24 absolute among the denormals; half of both of central moments, which
// the shader rounds.
double store_share(const Settings &settings);
double store_absolute(const Settings &settings);

// The relative error of a texel's moments against the mean of its N samples,
// and below 2^-14 the absolute one: N - 1 sums, a quotient, and a store. 0
// without --msaa.
double resolve_share(const Settings &settings);
double resolve_absolute(const Settings &settings);

// A bilinear lookup's error as a share of the largest of the four texels: two
// nested interpolations a + w (b - a) (difference, product, sum: 3 each), or
// four products with rounded weights, which is no more.
constexpr int LOOKUP_ROUNDINGS = 6;

#endif
