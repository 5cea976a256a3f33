// Step 5, --min-variance auto: how much of the variance can be lost to rounding
// on the way from the map to the bound, and how far the mean can be off. The
// proof, once:
//
// ASSUMPTIONS. Depths are in [0, 1] and weights w at least 0. The depth that a
// texel holds, the receiver's depth t, the weights and where a lookup falls
// between texels are inputs: the exact moments are of those. (A texture unit
// that has 8 bits for that place looks up elsewhere.) Every operation rounds:
// fl(z) = z (1 + x) + y, |x| <= u = 2^-24, |y| <= 2^-126, as GPUs may flush
// denormals. A store rounds once more, by s of its value and at least e: s = 0
// of 32-bit floats, 2^-11 of 16-bit ones rounded to nearest, 2^-10 cut off. A
// pass merges n taps, the heaviest of weight h: it adds n products in some
// order, so a term meets its product and at most n - 1 additions, n roundings.
// Its weights add up to 1 + q, for they were rounded. Hats are computed.
//
// RAW. All terms are positive, so the relative errors of terms are those of
// sums: 1 + E = product over passes of (1 + u)^n (1 + s) (1 + |q|),
//     |M1^ - M1| <= E M1,  |M2^ - M2| <= E2 M2,
// E2 = E with the rounding of x * x, and of x and its square stored: (1 + E)
// (1 + u) (1 + s) / (1 - s)^2 - 1. V^ = fl(M2^ - fl(M1^^2)) is off by both, and
// by two roundings of numbers up to (1 + E2) M2 and (1 + E)^2 M1^2. M1^2 <= M2:
//     |V^ - V| <= K M2,  K = E2 + (2 E + E^2) + 2 u (1 + E2) (1 + E)^2,
// about (3 N + 3) u M2 for N roundings. A V^ below 0 is taken for 0.
// A texture unit blends a + w (b - a) along one axis, then along the other.
// Where a is large and the result small, the rounding is a share of a: 3 u A
// for each, with A the largest depth, at most 1, and 3 u A^2 for M2. A
// summed-area table rounds by half a step and 24 u. L is the sum of these,
// times 1 + E2: M1 is off by another L A, V by 3 L (1 + E + L) A^2.
//
// CENTRAL. A merge about c, the mean of its heaviest tap: s = sum w (m - c),
// M = c + s, V = S - s^2, S = sum w (v + (m - c)^2). A term of S meets two
// roundings in its difference, one in the square, one in v +, its product and
// n - 1 additions: n + 4; s n + 1, s^2 2 n + 3, the last difference one. All
// are of numbers up to D = V + (M - c)^2, as |M - c| <= sum w |m - c| <=
// sqrt(D); q takes part once in S and twice in s^2. With 4 u for the second
// order V is off by ((3 n + 12) u + 3 |q|) D. If c is d away from M, the
// others, of weight 1 - h, are h d / (1 - h) away on average, so V >= h d^2 +
// h^2 d^2 / (1 - h) = h d^2 / (1 - h), and D = V + d^2 <= V / h. So this is a
// *relative* error of V, however close the depths are:
//     R = ((3 n + 12) u + 3 |q|) / h + s.
// The mean is off by (u + s) min(M, 1/2), for all floats from 1/2 to 1 are
// equally far apart, and by ((n + 3) u + |q|) sqrt(V / h) from s.
// A later pass sees means that are off by e_i. A standard deviation is a norm,
// of the numbers sqrt(v_i) and m_i - M under the weights: moving m_i by e_i
// changes it by at most sqrt(sum w e_i^2), v_i being off by R by R / 2 of it.
// Only means before the last pass matter. With F the sum of u + s over all
// passes but the last and
//     G = sum over passes of R / 2 + ((n + 3) u + |q|) / sqrt(h):
//     |sqrt(V^) - sqrt(V)| <= G sqrt(V) + F min(sqrt(M2), 1/2),
//     |M1^ - M1| <= (F + u) min(M1, 1/2) + G sqrt(V).
// A lookup's merge of two, d apart, has only positive terms: part (1 - part)
// d^2 with 8 roundings is 4 u of the deviation. Its mean is off by 3 u of the
// smaller part of d, which is at most sqrt(V). So its part of G is 7 u.
//
// UNDERFLOW. A y or e in a sum adds up to n y and e for each pass: of V^, as
// merges are linear in v, and of M1^, where it counts as e_i.
//
// AUTO adds to the variance the most that it can have lost, and takes from
// t - M1 the most that it can have gained, so p^ = V^ / (V^ + (t - M1^)^2) is
// at least p, and p >= the lit share (Cantelli), up to 12 u of the formula's
// own roundings: (t - M1)^2 5 u and V 17 u, which move p by p (1 - p) <= 1/4
// of that; a sum and a quotient 6 u. Adding is needed: a maximum with K M2 does
// nothing where V = 2 K M2, and two depths leave Cantelli no slack. What is
// added is a share of what was computed, which may be less than the exact
// number by the sum of all errors: it is divided by 1 less that sum. Of central
// moments the root is of V^ and what underflow took, for a root magnifies that.
//
// WHAT IT DOES NOT SAY. t is interpolated, and so is the depth in the map:
// OpenGL does not bound by how much (see guard_central.glsl). OpenGL allows a
// quotient 5 u where this has u: averages of a number of texels that is no
// power of two, and running boxes, divide once each. Products of errors are in
// factors 1 + 8 (...), which hold up to G = 1/8; from there on, a box wider
// than some 700 texels, there is no promise.
#ifndef STEP5_GUARD_H
#define STEP5_GUARD_H

#include <stdbool.h>

// One of the averages in a row.
typedef struct GuardPass {
    int taps;
    double heaviest; // the largest of its weights
    double defect;   // how far they are from adding up to 1
    bool stored;     // in a texel, before the next one
    bool two;        // of two: raw a + w (b - a), central merge_two()
} GuardPass;

enum { GUARD_MAX_PASSES = 32 };

// Everything between the depths that a map holds and the bound.
typedef struct GuardChain {
    bool central;
    double store_roundoff; // s
    double store_tiny;     // half a step, where the format has fixed ones
    double table_error;    // of a summed-area table; 0: none
    GuardPass passes[GUARD_MAX_PASSES];
    int count;
} GuardChain;

void guard_add(GuardChain *chain, GuardPass pass);

// A pass whose weights are all the same, and stored.
void guard_add_box(GuardChain *chain, int taps);

// A bilinear lookup: two rows, then both together.
void guard_add_bilinear(GuardChain *chain);

// The same as GuardNumbers (chebyshev.h) of any chain. Of central moments
// `spread` is a part of the deviation, and guard_central.glsl takes the others
// differently.
typedef struct ChainNumbers {
    float variance[2];
    float mean[2];
    float spread;
} ChainNumbers;

ChainNumbers guard_numbers(const GuardChain *chain);

#endif
