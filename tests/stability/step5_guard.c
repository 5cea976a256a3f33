#include "tests/stability/step5_guard.h"

#include <math.h>  // fmax, fmin
#include <stdio.h> // printf

#include "step5_chebyshev/chebyshev.h" // chebyshev_guard
#include "step5_chebyshev/techniques/guard/guard.h"
#include "tests/stability/bound.h" // errors_of

static GuardChain step5_chain(const Chain *chain)
{
    GuardChain result = {.central = chain->central,
                         .store_roundoff = chain->format->roundoff,
                         .store_tiny = chain->format->tiny};
    if (chain->factor > 1) {
        guard_add_box(&result, chain->factor * chain->factor);
    }
    double sum = 0, heaviest = 0;
    for (int i = 0; i < chain->taps; i++) {
        sum += (double)chain->weights[i];
        heaviest = fmax(heaviest, (double)chain->weights[i]);
    }
    for (int axis = 0; axis < 2 && chain->taps > 1; axis++) {
        guard_add(&result, (GuardPass){.taps = chain->taps,
                                       .heaviest = heaviest,
                                       .defect = fabs(sum - 1),
                                       .stored = true});
    }
    // Step 5 always looks up: where this chain does not, it adds more.
    guard_add_bilinear(&result);
    return result;
}

Guard guard_of_step5(const Chain *chain)
{
    GuardChain own = step5_chain(chain);
    ChainNumbers numbers = guard_numbers(&own);
    return (Guard){.variance = numbers.variance[0],
                   .deviation = numbers.spread,
                   .mean = numbers.mean[0],
                   .tiny = numbers.variance[1],
                   .tiny_shift = numbers.mean[1]};
}

// From the error to half more than what is asked for; `extra` is what step 5
// adds besides, on purpose.
static bool within(float own, double error, float asked, double extra)
{
    return (double)own >= error && (double)own <= 1.5 * (double)asked + extra;
}

bool step5_guards(const Chain *chain)
{
    if (chain->lookup == LOOKUP_NONE) {
        return true;
    }
    Errors e = errors_of(chain);
    Guard asked = guard_of(chain), own = guard_of_step5(chain);
    // The depth's own store, and adding it.
    double store = (chain->central ? chain->format->roundoff : 0) + ROUNDOFF;
    return within(own.variance, e.variance, asked.variance, 0) &&
           within(own.deviation, e.deviation, asked.deviation, 0) &&
           within(own.mean, e.mean, asked.mean, 2 * store) &&
           within(own.tiny, e.lerp2, asked.tiny, 0) &&
           within(own.tiny_shift, e.lerp, asked.tiny_shift, 0);
}

// A box of this radius after downsampling by a factor, as guard_settings.c has
// it.
static ChainNumbers of_chain(int radius, int factor)
{
    GuardChain chain = {.central = false};
    int taps = 2 * radius + 1;
    if (factor > 1) {
        guard_add_box(&chain, factor * factor);
    }
    for (int axis = 0; axis < 2 && radius > 0; axis++) {
        guard_add(&chain, (GuardPass){.taps = taps,
                                      .heaviest = 1.0 / taps,
                                      .defect = ROUNDOFF,
                                      .stored = true});
    }
    guard_add_bilinear(&chain);
    return guard_numbers(&chain);
}

void print_closed_form(void)
{
    for (int factor = 1; factor <= 16; factor *= 2) {
        double least = HUGE_VAL, most = 0;
        for (int radius = 0; radius <= 1024; radius++) {
            GuardNumbers own = chebyshev_guard(radius, factor);
            ChainNumbers chain = of_chain(radius, factor);
            for (int i = 0; i < 2; i++) {
                double mean = (double)own.mean[i] / (double)chain.mean[i];
                double variance =
                    (double)own.variance[i] / (double)chain.variance[i];
                least = fmin(least, fmin(mean, variance));
                most = fmax(most, fmax(mean, variance));
            }
        }
        printf("factor %d: %.5f to %.5f\n", factor, least, most);
    }
}
