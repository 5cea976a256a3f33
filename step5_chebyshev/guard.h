// Step 5, --min-variance auto: how much of the variance can be lost to rounding
// on the way from the map to the bound, and how far the mean can be off. The
// proof, once:
//
// ASSUMPTIONS. Depths are in [0, 1] and weights w at least 0. The depth that a
// texel holds, the receiver's depth t and the weights are inputs: the exact
// moments are of those. Every operation rounds: fl(z) = z (1 + x) + y, |x| <= u
// = 2^-24, |y| <= 2^-126 (GPUs may flush denormals). A store rounds by s of its
// value: s = 0 of 32-bit floats, 2^-11 of 16-bit ones rounded to nearest, 2^-10
// cut off. A pass of n taps adds w m in some order: a term meets its product
// and at most n - 1 additions, n roundings. Its weights add up to 1 + q.
//
// RAW. All terms are positive, so the relative errors of terms are those of
// sums: 1 + E = product over passes of (1 + u)^n (1 + s) (1 + q),
//     |M1^ - M1| <= E M1,  |M2^ - M2| <= E2 M2,
// E2 = E with the rounding of x * x, and of x and its square stored: (1 + E)
// (1 + u)(1 + s) / (1 - s)^2 - 1. As M1^2 <= M2, the variance V is off by at
// most K M2, K = E2 + 2 E + E^2 + 2 u (1 + E)^2.
// A texture unit blends a + w (b - a) along one axis, then along the other.
// Where a is large and the result small the rounding is a share of a: at most
// 3 u for each of them, as depths are at most 1. A summed-area table rounds by
// half a step and 24 u. L is the sum of these: M1 is off by another L, V by
// 3 L (1 + E + L).
//
// CENTRAL. A merge about c, the mean of its heaviest tap: s = sum w (m - c),
// V = S - s^2, S = sum w (v + (m - c)^2). A term of S meets n + 4 roundings, s
// n + 1, s^2 2 n + 3, the last difference one: of D = V + (M - c)^2 an error of
// (3 n + 12) u + 3 |q|. c's own part says V >= h (M - c)^2 / (1 - h) with its
// weight h, so D <= V / h and V is off by a *relative*
//     R = ((3 n + 12) u + 3 |q|) / h + s,
// however close the depths are. The mean is off by (u + s) min(M, 1/2), for all
// floats from 1/2 to 1 are equally far apart, and by ((n + 3) u + |q|)
// sqrt(V / h). Later passes see moved means; a standard
// deviation is a norm of them, so it changes by no more than their (weighted,
// square) mean motion. Only means before the last pass matter. With
// G = sum over passes of R / 2 + ((n + 3) u + |q|) / sqrt(h):
//     |sqrt(V^) - sqrt(V)| <= G sqrt(V) + F min(sqrt(M2), 1/2),
//     |M1^ - M1| <= (F + u) min(M1, 1/2) + G sqrt(V),
// F the sum of u + s over all passes but the last. A merge of two, a distance d
// apart, has only positive terms: part (1 - part) d^2 with 8 roundings is 4 u
// of the deviation, and the mean is off by 3 u of the smaller part of d, which
// is at most sqrt(V): its G is 7 u.
//
// AUTO adds to the variance the most that it can have lost, and takes from
// t - M1 the most that it can have gained, so p^ = V^ / (V^ + (t - M1^)^2) >=
// p, and p >= the lit share (Cantelli), up to 12 u for the formula's own
// operations. Adding is needed: a maximum with K M2 does nothing where
// V = 2 K M2, and two depths leave Cantelli no slack. What is added is a share
// of what was computed, so it is a little more than that of the exact number.
//
// WHAT IT DOES NOT SAY. t is interpolated, and so is the depth in the map:
// OpenGL does not bound by how much (see guard_central.glsl). Where G passes
// 1/8 the terms of second order count, and there is no promise: a box wider
// than some 700 texels.
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

// The uniforms of guard_raw.glsl and guard_central.glsl.
typedef struct GuardNumbers {
    float spread;
    float variance[2];
    float mean[2];
} GuardNumbers;

void guard_add(GuardChain *chain, GuardPass pass);

// A pass whose weights are all the same, and stored.
void guard_add_box(GuardChain *chain, int taps);

// A bilinear lookup: two rows, then both together.
void guard_add_bilinear(GuardChain *chain);

GuardNumbers guard_numbers(const GuardChain *chain);

#endif
