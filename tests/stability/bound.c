#include "tests/stability/bound.h"

#include <math.h> // fmax

#define UNDERFLOW 0x1p-126

// One merge: its taps, how far its weights are from 1, the largest of them.
typedef struct Pass {
    int taps;
    double defect;
    double heaviest;
} Pass;

static Pass pass_of(const float *weights, int taps)
{
    Pass pass = {.taps = taps};
    double sum = 0;
    for (int i = 0; i < taps; i++) {
        sum += weights[i];
        pass.heaviest = fmax(pass.heaviest, weights[i]);
    }
    pass.defect = fabs(sum - 1);
    return pass;
}

static int passes_of(const Chain *chain, Pass passes[4])
{
    const float quarter[] = {0.25F, 0.25F, 0.25F, 0.25F};
    float lookup[4];
    int count = 0;
    if (chain->factor > 1) {
        passes[count++] = pass_of(quarter, 4);
    }
    // One tap of weight 1 changes nothing.
    for (int axis = 0; axis < 2 && chain->taps > 1; axis++) {
        passes[count++] = pass_of(chain->weights, chain->taps);
    }
    lookup_weights(chain, lookup);
    passes[count++] = pass_of(lookup, 4);
    return count;
}

static Errors raw_errors(const Format *format, const Pass *passes, int count)
{
    double s = format->roundoff;
    double factor = 1;
    double underflows = format->tiny;
    for (int i = 0; i < count; i++) {
        double stored = i < count - 1 ? 1 + s : 1;
        factor *=
            pow(1 + ROUNDOFF, passes[i].taps) * stored * (1 + passes[i].defect);
        underflows += passes[i].taps * UNDERFLOW + format->tiny;
    }
    double e = factor - 1;
    double e2 = factor * (1 + ROUNDOFF) * (1 + s) / ((1 - s) * (1 - s)) - 1;
    return (Errors){.mean = e,
                    .variance =
                        e2 + 2 * e + e * e + 2 * ROUNDOFF * (1 + e) * (1 + e),
                    .tiny = 6 * (underflows + UNDERFLOW),
                    .tiny_shift = 2 * (underflows + UNDERFLOW)};
}

static Errors central_errors(const Format *format, const Pass *passes,
                             int count)
{
    double s = format->roundoff;
    Errors errors = {.mean = count * (ROUNDOFF + s),
                     .variance = (count - 1) * (ROUNDOFF + s)};
    for (int i = 0; i < count; i++) {
        double n = passes[i].taps;
        double h = passes[i].heaviest;
        double q = passes[i].defect;
        double relative = ((3 * n + 12) * ROUNDOFF + 3 * q) / h + s;
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

Errors errors_of(const Chain *chain)
{
    Pass passes[4];
    int count = passes_of(chain, passes);
    return chain->central ? central_errors(chain->format, passes, count)
                          : raw_errors(chain->format, passes, count);
}

// The guard multiplies what was computed, not what is exact.
Guard guard_of(const Chain *chain)
{
    Errors e = errors_of(chain);
    double more = 1 / (1 - e.variance - e.mean - e.deviation) + 8 * ROUNDOFF;
    return (Guard){.variance = (float)(e.variance * more),
                   .deviation = (float)(e.deviation * more),
                   .mean = (float)(e.mean * more),
                   .tiny = (float)(2 * e.tiny),
                   .tiny_shift = (float)(2 * e.tiny_shift)};
}

// Everything that the variance can be, `times` errors away.
static double most_variance(const Chain *chain, const Exact *exact,
                            double times)
{
    Errors e = errors_of(chain);
    if (!chain->central) {
        return exact->variance + times * (e.variance * exact->m2 + e.tiny);
    }
    double deviation = sqrt(exact->variance) * (1 + times * e.deviation) +
                       times * (e.variance * sqrt(exact->m2) + e.tiny_shift);
    return deviation * deviation + times * e.tiny;
}

static double least_variance(const Chain *chain, const Exact *exact)
{
    Errors e = errors_of(chain);
    if (!chain->central) {
        return fmax(exact->variance - e.variance * exact->m2 - e.tiny, 0);
    }
    double deviation = sqrt(exact->variance) * (1 - e.deviation) -
                       e.variance * sqrt(exact->m2) - e.tiny_shift;
    return fmax(deviation > 0 ? deviation * deviation - e.tiny : 0, 0);
}

double variance_bound(const Chain *chain, const Exact *exact)
{
    return fmax(most_variance(chain, exact, 1) - exact->variance,
                exact->variance - least_variance(chain, exact));
}

static double cantelli(double variance, double behind)
{
    return behind > 0 ? variance / (variance + behind * behind) : 1;
}

double p_bound(const Chain *chain, const Exact *exact, bool guarded)
{
    Errors e = errors_of(chain);
    // With the guard an error is met by another one of the same size, and by
    // a little for being a part of what was computed.
    double times = guarded ? 2.25 : 1;
    double shift = e.mean * exact->mean + e.tiny_shift +
                   e.deviation * sqrt(exact->variance);
    shift += 2 * ROUNDOFF * fabs(exact->behind);
    double most = cantelli(most_variance(chain, exact, times) + UNDERFLOW,
                           exact->behind - times * shift);
    double least =
        cantelli(least_variance(chain, exact), exact->behind + shift);
    least = guarded ? exact->p : least;
    return fmin(fmax(most - exact->p, exact->p - least) + LAST_ROUNDINGS, 1);
}

float p_today(const Chain *chain, const Estimate *estimate, float t)
{
    float u = (float)fmax(chain->format->roundoff, ROUNDOFF);
    float m2 = estimate->variance + estimate->mean * estimate->mean;
    float variance = fmaxf(estimate->variance, 4 * u * m2);
    float behind = t - estimate->mean;
    return behind > 0 ? variance / (variance + behind * behind) : 1;
}
