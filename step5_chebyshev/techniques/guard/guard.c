#include "step5_chebyshev/techniques/guard/guard.h"

#include <math.h> // pow

#include "step1_shadowmap/base/system/die.h" // die

#define ROUNDOFF 0x1p-24
#define UNDERFLOW 0x1p-126

// Beyond it the second order is not small any more: no promise, but finite.
#define MOST_SPREAD 0.125

void guard_add(GuardChain *chain, GuardPass pass)
{
    if (chain->count == GUARD_MAX_PASSES) {
        die("more than %d averages in a row", GUARD_MAX_PASSES);
    }
    chain->passes[chain->count++] = pass;
}

void guard_add_box(GuardChain *chain, int taps)
{
    // One rounding more: the sum is divided.
    guard_add(
        chain,
        (GuardPass){.taps = taps + 1, .heaviest = 1.0 / taps, .stored = true});
}

void guard_add_bilinear(GuardChain *chain)
{
    for (int axis = 0; axis < 2; axis++) {
        guard_add(chain, (GuardPass){.two = true});
    }
}

// The sums and products of proof.md. Whatever was computed may be smaller than
// what is exact, by all the errors together: hence `more`.
static ChainNumbers raw_numbers(const GuardChain *chain)
{
    double s = chain->store_roundoff;
    double growth = 1, fixed = chain->table_error;
    double tiny = UNDERFLOW + chain->store_tiny;
    for (int i = 0; i < chain->count; i++) {
        const GuardPass *pass = &chain->passes[i];
        growth *= pow(1 + ROUNDOFF, pass->taps) * (1 + pass->defect) *
                  (pass->stored ? 1 + s : 1);
        fixed += pass->two ? 3 * ROUNDOFF : 0;
        tiny += (2 + pass->taps) * UNDERFLOW;
        tiny += pass->stored ? chain->store_tiny : 0;
    }
    double e = growth - 1;
    double e2 = growth * (1 + ROUNDOFF) * (1 + s) / ((1 - s) * (1 - s)) - 1;
    double k = e2 + 2 * e + e * e + 2 * ROUNDOFF * (1 + e2) * (1 + e) * (1 + e);
    fixed *= 1 + e2;
    double more = 1 / (1 - k - e) + 8 * ROUNDOFF;
    e += ROUNDOFF; // of adding it
    return (ChainNumbers){
        .variance = {(float)(more * k),
                     (float)(more *
                             (3 * fixed * (1 + e + fixed + k) + 4 * tiny))},
        .mean = {(float)(more * e), (float)(more * (fixed + 2 * tiny))}};
}

// The error of a pass in parts of the deviation.
static double spread_of(const GuardPass *pass, double store_roundoff)
{
    double s = pass->stored ? store_roundoff : 0;
    if (pass->two) {
        return 7 * ROUNDOFF + s;
    }
    double n = pass->taps, h = pass->heaviest, q = pass->defect;
    double variance = ((3 * n + 12) * ROUNDOFF + 3 * q) / h + s;
    return variance / 2 + ((n + 3) * ROUNDOFF + q) / sqrt(h);
}

static ChainNumbers central_numbers(const GuardChain *chain)
{
    double spread = 0, means = 0, tiny = UNDERFLOW;
    for (int i = 0; i < chain->count; i++) {
        const GuardPass *pass = &chain->passes[i];
        spread += spread_of(pass, chain->store_roundoff);
        means += ROUNDOFF + (pass->stored ? chain->store_roundoff : 0);
        tiny += 4 * (2 + pass->taps) * UNDERFLOW;
        tiny += pass->stored ? chain->store_tiny : 0;
    }
    // The last pass is the lookup's, in which nothing is stored.
    double before_last = means - ROUNDOFF;
    // Second order: products of these.
    spread = fmin(spread, MOST_SPREAD);
    double products = 1 + 8 * (spread + means);
    spread = fmin(spread * products, MOST_SPREAD);
    means *= products;
    before_last *= products;
    double more = 1 / (1 - spread - 2 * means) + 8 * ROUNDOFF;
    // And of adding it, and of the depth's own store: a plane is not behind
    // what was stored of it.
    means += ROUNDOFF + chain->store_roundoff;
    return (ChainNumbers){
        .spread = (float)(more * spread + 8 * ROUNDOFF),
        .variance = {(float)(more * before_last), (float)(more * tiny)},
        .mean = {(float)(more * means), (float)(more * tiny)}};
}

ChainNumbers guard_numbers(const GuardChain *chain)
{
    return chain->central ? central_numbers(chain) : raw_numbers(chain);
}
