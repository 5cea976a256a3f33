// Random windows of depths, the same ones for the same seed everywhere.

#ifndef STABILITY_WINDOWS_H
#define STABILITY_WINDOWS_H

#include <stdint.h> // uint64_t

#include "tests/stability/formulas.h" // Chain, Window

typedef struct Random {
    uint64_t state;
} Random;

uint32_t random_bits(Random *random);
double random_part(Random *random);          // in [0, 1)
int random_below(Random *random, int below); // 0 to below - 1

typedef enum Kernel {
    KERNEL_BOX,
    KERNEL_GAUSSIAN,
    KERNEL_RANDOM,
    KERNEL_WIDE_GAUSSIAN // weights from 1e-6 of the largest
} Kernel;

// `taps` weights that add up to 1 but for their rounding.
void chain_set_kernel(Chain *chain, Kernel kernel, int taps, Random *random);

// Depths of any bit pattern in [0, 1], or close to each other in one of
// several ways; t among them, beside them or anywhere.
void random_window(Random *random, const Chain *chain, Window *window);

#endif
