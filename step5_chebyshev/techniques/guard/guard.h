// Step 5, --min-variance auto: how much of the variance can be lost to rounding
// on the way from the map to the bound, and how far the mean can be off. The
// proof is in step5_chebyshev/techniques/guard/proof.md.
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
