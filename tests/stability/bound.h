// How wrong the bound p can be, and what the minimum variance has to be so
// that p never falls below the lit share. The proof, once:
//
// ASSUMPTIONS. Depths d are in [0, 1] and weights w at least 0; the depth a
// texel holds, t and the weights are inputs (exact are the moments of those).
// Every operation rounds: fl(z) = z (1 + x) + y, |x| <= u = 2^-24 and |y| <=
// 2^-126 (which allows GPUs to flush denormals). A store rounds once more, by
// s of its value: s = 0 in fp32, 2^-11 in fp16 rounded to nearest, 2^-10
// truncated. A pass of n taps adds w m in some order: a term meets its product
// and at most n - 1 additions, so n roundings. Its weights add up to 1 + q,
// |q| <= n u (each was rounded; here |q| is measured). P passes in a row:
// downsampling, two axes, lookup.
//
// RAW. All terms are positive, so relative errors of terms are those of sums:
//     1 + E = product over passes of (1 + u)^n (1 + s) (1 + q),
//     |M1^ - M1| <= E M1,  |M2^ - M2| <= E2 M2,
// E2 = E with the rounding of x * x, and in fp16 with that of d and of its
// square: (1 + E)(1 + u)(1 + s) / (1 - s)^2 - 1. As M1^2 <= M2,
//     |V^ - V| <= K M2,  K = E2 + (2 E + E^2) + 2 u (1 + E)^2.
// This is about (3 N + 3) u M2 for N roundings: the condition number M2 / V,
// times u, times the chain.
//
// CENTRAL. A merge about c, a mean of its own, gives with D = sum w (v + (m -
// c)^2) = V + (M - c)^2 an error of (3 n + 12) u D + 3 |q| D. As c's weight h
// is the largest, V >= h (M - c)^2 / (1 - h), so D <= V / h: a *relative* error
//     R = ((3 n + 12) u + 3 |q|) / h + s
// however close the depths are. Means are rounded too, by (u + s) |m|: that
// moves a cluster of depths, and a standard deviation is a norm: moving every
// depth by e_i changes it by at most sqrt(sum w e_i^2) <= (u + s) sqrt(M2).
// Only stores before the last merge matter:
//     |sqrt(V^) - sqrt(V)| <= G sqrt(V) + (P - 1)(u + s) sqrt(M2),
//     |M1^ - M1| <= P (u + s) M1 + G sqrt(V),
// G = sum over passes of R / 2 + ((n + 3) u + |q|) / sqrt(h).
//
// THE BOUND p = V / (V + (t - M1)^2) grows with V and falls with t - M1, so its
// extremes are in the corners of those intervals. To first order
//     |p^ - p| <= p (1 - p) (|V^ - V| / V + 2 |M1^ - M1| / (t - M1)).
//
// AUTO adds to V^ the most that it can have lost, and takes from t - M1^ the
// most that it can have gained. Then p^ >= p, and p >= the lit share
// (Cantelli), up to 8 u for the last few operations. Adding is needed: a
// maximum with K M2 does nothing where V = 2 K M2, and two depths leave
// Cantelli no slack.

#ifndef STABILITY_BOUND_H
#define STABILITY_BOUND_H

#include "tests/stability/formulas.h" // Chain

#define ROUNDOFF 0x1p-24
#define LAST_ROUNDINGS (8 * ROUNDOFF)

// Relative and absolute errors of a chain, whatever the depths.
typedef struct Errors {
    double mean;       // of M1
    double variance;   // raw: K, of M2; central: of sqrt(M2) in the deviation
    double deviation;  // central: G, of the deviation; raw: 0
    double tiny;       // of underflow: of the variance,
    double tiny_shift; // and of the mean (central: and of the deviation)
} Errors;

Errors errors_of(const Chain *chain);

// What `auto` has to be for this chain.
Guard guard_of(const Chain *chain);

// The most that the computed variance can differ from the exact one.
double variance_bound(const Chain *chain, const Exact *exact);

// The most that p can differ from the exact one, in [0, 1], with nothing added
// or with `auto`.
double p_bound(const Chain *chain, const Exact *exact, bool guarded);

// 4 u M2, as step 5 has it today: a maximum, and no shrinking.
float p_today(const Chain *chain, const Estimate *estimate, float t);

#endif
