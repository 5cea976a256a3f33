// How wrong the bound p can be, and what the minimum variance has to be so that
// p never falls below the lit share. The proof and the names (u, s, e, q, h, E,
// K, L, R, F, G) are in step5_chebyshev/techniques/guard/proof.md; this is the
// same once more, in other code, for one window of depths at a time. Where more
// is known here, the bound is sharper:
// - |q| is measured, and A is the largest depth of the window and not 1;
// - a chain may end without a lookup: then its last merge's mean is stored, and
//   F leaves out that store as well.
//
// THE BOUND p = V / (V + (t - M1)^2) grows with V and falls with t - M1, so its
// extremes are in the corners of the intervals of both. To first order
//     |p^ - p| <= p (1 - p) (|V^ - V| / V + 2 |M1^ - M1| / (t - M1)).
// With `auto` p^ is at least p, and at most what auto makes of the largest
// numbers that can have been computed. Both up to the 12 u of p's own
// roundings.

#ifndef STABILITY_BOUND_H
#define STABILITY_BOUND_H

#include "tests/stability/formulas.h" // Chain

#define ROUNDOFF 0x1p-24
#define LAST_ROUNDINGS (12 * ROUNDOFF)

// Relative and absolute errors of a chain, whatever the depths.
typedef struct Errors {
    double mean;       // of M1
    double variance;   // raw: K, of M2; central: of sqrt(M2) in the deviation
    double deviation;  // central: G, of the deviation; raw: 0
    double lerp;       // of the largest depth A, in M1,
    double lerp2;      // and of A^2, in V
    double tiny;       // of underflow: of the variance,
    double tiny_shift; // and of the mean (central: and of the deviation)
} Errors;

Errors errors_of(const Chain *chain);

// What `auto` has to be for this chain.
Guard guard_of(const Chain *chain);

// The most that the computed variance can differ from the exact one.
double variance_bound(const Chain *chain, const Exact *exact);

// The most that the computed numbers can be.
typedef struct Computed {
    double mean, variance, m2;
} Computed;

Computed computed_most(const Chain *chain, const Exact *exact);

// The most that p can differ from the exact one, in [0, 1], with nothing added
// or with `auto`.
double p_bound(const Chain *chain, const Exact *exact, bool guarded);

// 4 u M2, a maximum and no shrinking: what most programs have, at best.
float p_at_least_4u(const Chain *chain, const Estimate *estimate, float t);

#endif
