#include "tests/stability/bound.h"

#include <math.h> // fmax

#define UNDERFLOW 0x1p-126

// One merge: its taps, how far its weights are from 1, the largest of them.
typedef struct Pass {
    int taps;
    double defect;
    double heaviest;
} Pass;

typedef struct Passes {
    Pass all[3];
    int count;
    int lookups; // merges of two, after those
} Passes;

static void add_pass(Passes *passes, const float *weights, int taps)
{
    Pass *pass = &passes->all[passes->count++];
    *pass = (Pass){.taps = taps};
    double sum = 0;
    for (int i = 0; i < taps; i++) {
        sum += weights[i];
        pass->heaviest = fmax(pass->heaviest, weights[i]);
    }
    pass->defect = fabs(sum - 1);
}

static Passes passes_of(const Chain *chain)
{
    const float quarter[] = {0.25F, 0.25F, 0.25F, 0.25F};
    Passes passes = {.lookups = chain->lookup == LOOKUP_NONE ? 0 : 2};
    if (chain->factor > 1) {
        add_pass(&passes, quarter, 4);
    }
    // One tap of weight 1 changes nothing.
    for (int axis = 0; axis < 2 && chain->taps > 1; axis++) {
        add_pass(&passes, chain->weights, chain->taps);
    }
    return passes;
}

static Errors raw_errors(const Chain *chain)
{
    Passes passes = passes_of(chain);
    double s = chain->format->roundoff;
    double factor = 1;
    double underflows = chain->format->tiny + 4 * passes.lookups * UNDERFLOW;
    for (int i = 0; i < passes.count; i++) {
        const Pass *pass = &passes.all[i];
        factor *= pow(1 + ROUNDOFF, pass->taps) * (1 + s) * (1 + pass->defect);
        underflows += pass->taps * UNDERFLOW + chain->format->tiny;
    }
    double e = factor - 1;
    double e2 = factor * (1 + ROUNDOFF) * (1 + s) / ((1 - s) * (1 - s)) - 1;
    double lerp = 3 * passes.lookups * ROUNDOFF * (1 + e2);
    return (Errors){.mean = e,
                    .variance = e2 + 2 * e + e * e +
                                2 * ROUNDOFF * (1 + e2) * (1 + e) * (1 + e),
                    .lerp = lerp,
                    .lerp2 = 3 * lerp * (1 + e + lerp + 4 * ROUNDOFF),
                    .tiny = 6 * (underflows + UNDERFLOW),
                    .tiny_shift = 2 * (underflows + UNDERFLOW)};
}

static Errors central_errors(const Chain *chain)
{
    Passes passes = passes_of(chain);
    const Format *format = chain->format;
    double stored = ROUNDOFF + format->roundoff;
    double means = passes.count * stored + passes.lookups * ROUNDOFF;
    double last = passes.lookups > 0 ? ROUNDOFF : stored;
    Errors errors = {.mean = means,
                     .variance = fmax(means - last, 0),
                     .deviation = 7 * passes.lookups * ROUNDOFF,
                     .tiny = 16 * passes.lookups * UNDERFLOW,
                     .tiny_shift = 4 * passes.lookups * UNDERFLOW};
    for (int i = 0; i < passes.count; i++) {
        double n = passes.all[i].taps;
        double h = passes.all[i].heaviest;
        double q = passes.all[i].defect;
        double relative =
            ((3 * n + 12) * ROUNDOFF + 3 * q) / h + format->roundoff;
        errors.deviation += relative / 2 + ((n + 3) * ROUNDOFF + q) / sqrt(h);
        errors.tiny += 4 * n * UNDERFLOW + 2 * format->tiny;
        errors.tiny_shift += 4 * n * UNDERFLOW + format->tiny;
    }
    // Second order: products of the terms above.
    errors.deviation *= 1 + 8 * errors.deviation;
    errors.variance *= 1 + 8 * (errors.deviation + errors.variance);
    errors.mean *= 1 + 8 * (errors.deviation + errors.mean);
    return errors;
}

static Errors times(Errors e, double factor)
{
    e.mean *= factor;
    e.variance *= factor;
    e.deviation *= factor;
    e.lerp *= factor;
    e.lerp2 *= factor;
    e.tiny *= factor;
    e.tiny_shift *= factor;
    return e;
}

Errors errors_of(const Chain *chain)
{
    Errors e = chain->central ? central_errors(chain) : raw_errors(chain);
    switch (chain->fault) {
    case BOUND_TENTH:
        return times(e, 0.1);
    case BOUND_TENFOLD:
        return times(e, 10);
    default:
        return e;
    }
}

// The guard multiplies what was computed, not what is exact; the largest depth
// is not known there, and 1 at most. The last term is its own arithmetic.
Guard guard_of(const Chain *chain)
{
    Errors e = errors_of(chain);
    double more = 1 / (1 - e.variance - e.mean - e.deviation) + 8 * ROUNDOFF;
    double own = chain->central ? 8 * ROUNDOFF : 0;
    return (Guard){.variance = (float)(e.variance * more),
                   .deviation = (float)(e.deviation * more + own),
                   .mean = (float)(e.mean * more),
                   .tiny = (float)(more * (e.lerp2 + 2 * e.tiny)),
                   .tiny_shift = (float)(more * (e.lerp + 2 * e.tiny_shift))};
}

// From 1/2 to 1 all floats are equally far apart.
static double rounded_most(double depth)
{
    return fmin(depth, 0.5);
}

// What was computed lies between these.
typedef struct Range {
    double least, most;
} Range;

static Range variance_range(const Errors *e, bool central, const Exact *exact)
{
    double v = exact->variance;
    if (!central) {
        double off = e->variance * exact->m2 +
                     e->lerp2 * exact->most_depth * exact->most_depth + e->tiny;
        return (Range){fmax(v - off, 0), v + off};
    }
    double off =
        e->deviation * sqrt(v) + e->variance * sqrt(exact->m2) + e->tiny_shift;
    double least = fmax(sqrt(v) - off, 0);
    double most = sqrt(v) + off;
    return (Range){fmax(least * least - e->tiny, 0), most * most + e->tiny};
}

double variance_bound(const Chain *chain, const Exact *exact)
{
    Errors e = errors_of(chain);
    Range v = variance_range(&e, chain->central, exact);
    return fmax(v.most - exact->variance, exact->variance - v.least);
}

// The most that the guard makes of a variance and an M2 up to these.
static double guarded_most(const Guard *guard, bool central, double variance,
                           double m2)
{
    if (!central) {
        return variance + guard->variance * m2 + guard->tiny;
    }
    double deviation = sqrt(variance + guard->tiny) * (1 + guard->deviation) +
                       guard->variance * rounded_most(sqrt(m2)) +
                       guard->tiny_shift;
    return deviation * deviation;
}

static double cantelli(double variance, double behind)
{
    return behind > 0 ? variance / (variance + behind * behind) : 1;
}

// How far M1^ can be off.
static double mean_off(const Errors *e, bool central, const Exact *exact)
{
    double mean = central ? rounded_most(exact->mean) : exact->mean;
    return e->mean * mean + e->lerp * exact->most_depth +
           e->deviation * sqrt(exact->variance) + e->tiny_shift;
}

Computed computed_most(const Chain *chain, const Exact *exact)
{
    Errors e = errors_of(chain);
    Computed most = {.mean = exact->mean + mean_off(&e, chain->central, exact),
                     .variance = variance_range(&e, chain->central, exact).most,
                     .m2 = exact->m2 * (1 + e.variance) + e.lerp2 + e.tiny};
    if (chain->central) {
        most.m2 = most.variance + most.mean * most.mean;
    }
    return most;
}

// What `auto` makes of the most that was computed.
static double most_guarded(const Chain *chain, const Exact *exact)
{
    Guard guard = guard_of(chain);
    Computed most = computed_most(chain, exact);
    double shift = guard.mean * most.mean + guard.tiny_shift;
    if (chain->central) {
        shift = guard.mean * rounded_most(most.mean) + guard.tiny_shift +
                guard.deviation * sqrt(most.variance + guard.tiny);
    }
    double variance =
        guarded_most(&guard, chain->central, most.variance, most.m2);
    double nearest = exact->behind - (most.mean - exact->mean) - shift;
    return cantelli(variance + UNDERFLOW, nearest);
}

double p_bound(const Chain *chain, const Exact *exact, bool guarded)
{
    if (guarded) {
        return fmin(most_guarded(chain, exact) - exact->p + LAST_ROUNDINGS, 1);
    }
    Errors e = errors_of(chain);
    Range v = variance_range(&e, chain->central, exact);
    double off = mean_off(&e, chain->central, exact);
    double most = cantelli(v.most + UNDERFLOW, exact->behind - off);
    double least = cantelli(v.least, exact->behind + off);
    return fmin(fmax(most - exact->p, exact->p - least) + LAST_ROUNDINGS, 1);
}

float p_at_least_4u(const Chain *chain, const Estimate *estimate, float t)
{
    float u = (float)fmax(chain->format->roundoff, ROUNDOFF);
    float m2 = estimate->variance + estimate->mean * estimate->mean;
    float variance = fmaxf(estimate->variance, 4 * u * m2);
    float behind = t - estimate->mean;
    return behind > 0 ? variance / (variance + behind * behind) : 1;
}
