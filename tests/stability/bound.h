// How wrong the bound p can be, and what the minimum variance has to be so
// that p never falls below the lit share. The proof, once:
//
// ASSUMPTIONS. Depths d are in [0, 1] and weights at least 0; the depth a texel
// holds, t, the blur's weights and where a lookup falls between texels are
// inputs (exact are the moments of those). Every operation rounds: fl(z) =
// z (1 + x) + y, |x| <= u = 2^-24 and |y| <= 2^-126 (which allows GPUs to flush
// denormals); a quotient or a root by no more than 5 u. A store rounds once
// more, by s of its value and at least e: s = 0 in fp32, 2^-11 in fp16 rounded
// to nearest, 2^-10 truncated. P passes in a row: downsampling, two axes,
// and the two halves of a lookup. A pass merges n taps of weights that add up
// to 1 + q (each was rounded; |q| is measured, not assumed), the heaviest of
// weight h. A sum adds its products one by one: a term meets its product and at
// most n - 1 additions, so n roundings. A lookup merges two texels, along one
// axis and then along the other.
//
// RAW. All terms are positive, so relative errors of terms are those of sums:
//     1 + E = product over passes of (1 + u)^n (1 + s) (1 + |q|),
//     |M1^ - M1| <= E M1,  |M2^ - M2| <= E2 M2,
// E2 = E with the rounding of x * x, and in fp16 with that of d (which was
// squared before it was stored) and of its square: (1 + E)(1 + u)(1 + s) /
// (1 - s)^2 - 1. V^ = fl(M2^ - fl(M1^^2)) is off by the two errors and two
// roundings of numbers up to (1 + E2) M2 and (1 + E)^2 (1 + u) M2; M1^2 <= M2:
//     |V^ - V| <= K M2,  K = E2 + (2 E + E^2) + 2 u (1 + E2)(1 + E)^2.
// This is about (3 N + 3) u M2 for N roundings: the condition number M2 / V,
// times u, times the chain. A clamp of V^ at 0 only helps, as V >= 0.
// A texture unit looks up by a + w (b - a), twice. Where a is large and the
// result small, the rounding is a share of a: with A the largest depth, each of
// the two adds 3 u A (A^2 to M2) in place of the factors above, L = 6 u (1 +
// E2) in all. |V^ - V| then grows by 3 L (1 + E + L) A^2, |M1^ - M1| by L A.
// (One with 8-bit weights looks up elsewhere: that moves an input.)
//
// CENTRAL. A merge about c, the mean of its heaviest tap: s = sum w (m - c),
// mean = c + s, variance = S - s^2, S = sum w (v + (m - c)^2). A term of S
// meets two roundings in its difference, one in the square, one in v +, its
// product and n - 1 additions, n + 4 in all; s n + 1 and s^2 2 n + 3; the last
// difference one more of S. Let D = V + (M - c)^2, what S is without rounding.
// As |M - c| <= sum w |m - c| <= sqrt(D), and q takes part once in S, twice in
// s^2, an error of ((3 n + 8) u + 3 |q|) D, and 4 u for the second order: 3 n +
// 12. c's own part says V >= h (M - c)^2 + (1 - h) (h (M - c) / (1 - h))^2 =
// h (M - c)^2 / (1 - h), so D <= V / h: a *relative* error of V,
//     R = ((3 n + 12) u + 3 |q|) / h + s
// however close the depths are. A mean is off by (u + s) min(m, 1/2), since
// from 1/2 to 1 all floats are equally far apart, and by ((n + 1) u + |q|)
// sqrt(D) from s. Later passes see a mean m_i that is off by
// e_i. A standard deviation is a norm, of the numbers sqrt(v_i) and m_i - M
// under the weights: moving m_i by e_i changes it by at most sqrt(sum w e_i^2),
// which is (u + s) min(sqrt(M2), 1/2) + ((n + 1) u + |q|) sqrt(V / h) at most,
// and v_i being off by R by R / 2 of it. Only means before the last merge
// matter:
//     |sqrt(V^) - sqrt(V)| <= G sqrt(V) + F min(sqrt(M2), 1/2),
//     |M1^ - M1| <= F' min(M1, 1/2) + G sqrt(V),
// F' the sum over all passes, F over all but the last of u, and s if it stores;
// G = sum over passes of R / 2 + ((n + 3) u + |q|) / sqrt(h). A lookup's merge
// of two, a distance d apart, (1 - a) v + a v' + a (1 - a) d^2, has only
// positive terms, of 8 roundings at most: 4 u of the deviation. Its mean is off
// by 3 u of the smaller part of d, min(a, 1 - a) d <= sqrt(V). So its part of G
// is 7 u. Products of these numbers are in the factors 1 + 8 (...) of the code,
// which hold up to G = 1/8.
//
// UNDERFLOW. A y or e in a sum of weights 1 + q adds up to n y and e per pass,
// Y in all: of V^ in both cases (a merge is linear in v), and of M1^, where it
// counts as e_i.
//
// THE BOUND p = V / (V + (t - M1)^2) grows with V and falls with t - M1, so its
// extremes are in the corners of those intervals. To first order
//     |p^ - p| <= p (1 - p) (|V^ - V| / V + 2 |M1^ - M1| / (t - M1)).
// Its own roundings: (t - M1)^2 by 5 u (two differences, a square), V with AUTO
// by 17 u (twice a root, two products, two sums; a square), which move p by
// p (1 - p) <= 1/4 of that; a sum and a quotient 6 u. 12 u together.
//
// AUTO adds to V^ the most that it can have lost, and takes from t - M1^ the
// most that it can have gained. Then p^ >= p, and p >= the lit share
// (Cantelli), up to those 12 u. Adding is needed: a maximum with K M2 does
// nothing where V = 2 K M2, and two depths leave Cantelli no slack. What it
// adds is a share of what was computed, which may be smaller than the exact
// number by T, the sum of all errors: it is divided by 1 - T. Of central
// moments the root takes V^ + Y, as V can have been Y more.

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
