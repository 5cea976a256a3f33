// Throws random depths at the formulas of steps 3 to 5 and holds their errors
// against the bound. `fuzz --help` lists what it can print.

#include <math.h>   // fabs
#include <stdio.h>  // printf
#include <stdlib.h> // strtol
#include <string.h> // strcmp

#include "tests/stability/bound.h"       // p_bound
#include "tests/stability/cases.h"       // print_case_rows
#include "tests/stability/search.h"      // NO_PROMISE
#include "tests/stability/step5_guard.h" // guard_of_step5
#include "tests/stability/windows.h"     // random_window

static const char usage[] =
    "fuzz [--count N] [--seed N] [--csv] [--break MISTAKE]\n"
    "     checks N random windows; --csv prints each one's error\n"
    "fuzz --shadows  p left in full shadow by gap and format\n"
    "fuzz --closed-form  step 5's closed form, in parts of guard.c's numbers\n"
    "fuzz --cases [--break MISTAKE]  extreme windows, as CSV\n"
    "mistakes: variance-sign, naive-merge, bound-tenth, bound-tenfold\n";

typedef enum What { WINDOWS, SAMPLES, SHADOWS, CLOSED_FORM, CASES } What;

typedef struct Options {
    long count;
    unsigned long seed;
    What what;
    Fault fault;
} Options;

static void stop(const char *what)
{
    fprintf(stderr, "fuzz: %s\n%s", what, usage);
    exit(2);
}

static Fault fault_named(const char *name)
{
    static const char *const names[] = {"", "variance-sign", "naive-merge",
                                        "bound-tenth", "bound-tenfold"};
    for (int fault = VARIANCE_SIGN; fault <= BOUND_TENFOLD; fault++) {
        if (strcmp(names[fault], name) == 0) {
            return (Fault)fault;
        }
    }
    stop("there is no such mistake");
    return NO_FAULT;
}

static What what_named(const char *word)
{
    static const char *const names[] = {"", "--csv", "--shadows",
                                        "--closed-form", "--cases"};
    for (int what = SAMPLES; what <= CASES; what++) {
        if (strcmp(names[what], word) == 0) {
            return (What)what;
        }
    }
    stop("what to do?");
    return WINDOWS;
}

static Options read_options(int count, char **words)
{
    Options options = {.count = 2000, .seed = 1};
    for (int i = 1; i < count; i++) {
        const char *value = i + 1 < count ? words[i + 1] : "";
        if (strcmp(words[i], "--count") == 0) {
            options.count = strtol(value, NULL, 10);
            i++;
        } else if (strcmp(words[i], "--seed") == 0) {
            options.seed = strtoul(value, NULL, 10);
            i++;
        } else if (strcmp(words[i], "--break") == 0) {
            options.fault = fault_named(value);
            i++;
        } else {
            options.what = what_named(words[i]);
        }
    }
    if (options.count < 1) {
        stop("--count takes a number from 1 on");
    }
    return options;
}

static Chain random_chain(Random *random, Fault fault)
{
    Chain chain = {.format = &formats[random_below(random, FORMATS)],
                   .central = random_below(random, 2) == 1,
                   .factor = 1 + random_below(random, 2),
                   .across = (float)random_part(random),
                   .up = (float)random_part(random),
                   .fault = fault};
    chain.lookup = random_below(random, 3) > 0 ? LOOKUP_BILINEAR : LOOKUP_NONE;
    Kernel kernel = (Kernel)random_below(random, 3);
    chain_set_kernel(&chain, kernel, 1 + 2 * random_below(random, 8), random);
    return chain;
}

// What a window says.
typedef struct Sample {
    Exact truth;
    Estimate raw;     // nothing added
    Estimate guarded; // with `auto`
    double variance, variance_bound;
    double p_error, p_bound;
    double guarded_error, guarded_bound;
    double below; // how far p with `auto` is below the lit share, with the
                  // bound's numbers or step 5's
    bool guards;  // step 5's numbers are the bound's
    double at_4u; // and with 4 u M2, a maximum
} Sample;

static Sample measure(const Chain *chain, const Window *window)
{
    const Guard none = {0};
    Guard guard = guard_of(chain);
    Sample s = {.truth = exact(chain, window),
                .raw = estimate(chain, window, &none),
                .guarded = estimate(chain, window, &guard)};
    s.variance = fabs((double)s.raw.variance - s.truth.variance);
    s.variance_bound = variance_bound(chain, &s.truth);
    s.p_error = fabs((double)s.raw.p - s.truth.p);
    s.p_bound = p_bound(chain, &s.truth, false);
    s.guarded_error = fabs((double)s.guarded.p - s.truth.p);
    s.guarded_bound = p_bound(chain, &s.truth, true);
    Guard own = guard_of_step5(chain);
    Estimate step5 = estimate(chain, window, &own);
    s.below = s.truth.lit - fmin((double)s.guarded.p, (double)step5.p);
    s.guards = step5_guards(chain);
    s.at_4u = s.truth.lit - (double)p_at_least_4u(chain, &s.raw, window->t);
    return s;
}

static bool sample_holds(const Sample *s)
{
    // Comparisons with NaN are false: it does not hold.
    return s->p_error <= s->p_bound && s->guarded_error <= s->guarded_bound &&
           s->variance <= s->variance_bound && s->guards &&
           s->below <= LAST_ROUNDINGS;
}

static const char *kind_of(const Chain *chain)
{
    return chain->central ? "central" : "raw";
}

static void print_failure(const Chain *chain, const Window *window,
                          const Sample *s)
{
    int side = chain_side(chain);
    printf("worst: %s %s, factor %d, %d taps, lookup at %a, %a\n",
           chain->format->name, kind_of(chain), chain->factor, chain->taps,
           (double)chain->across, (double)chain->up);
    printf("p %a, with auto %a, exact %a, lit %a\n", (double)s->raw.p,
           (double)s->guarded.p, s->truth.p, s->truth.lit);
    printf("of its bound: p %.3g, with auto %.3g; variance %a, bound %a\n",
           s->p_error / s->p_bound, s->guarded_error / s->guarded_bound,
           s->variance, s->variance_bound);
    printf("step 5 guards as it should: %s\n", s->guards ? "yes" : "no");
    printf("t %a, weights", (double)window->t);
    for (int i = 0; i < chain->taps; i++) {
        printf(" %a", (double)chain->weights[i]);
    }
    printf("\ndepths");
    for (int i = 0; i < side * side; i++) {
        printf(" %a", (double)window->depths[i]);
    }
    printf("\n");
}

// Errors in units of u V: how many of the 24 bits are gone, as a power of 2.
static void print_sample(const Chain *chain, const Sample *s)
{
    double unit = ROUNDOFF * s->truth.variance;
    if (s->truth.variance > 0x1p-100) {
        printf("%s-%s,%d,%.9g,%.4f,%.4f\n", chain->format->name, kind_of(chain),
               chain->taps, s->truth.m2 / s->truth.variance,
               log2(fmax(s->variance / unit, 1)),
               log2(fmax(s->variance_bound / unit, 1)));
    }
}

// The largest part of a bound that is reached. Where a bound promises nothing,
// an error of 1 is all of it.
static double severity(const Sample *s)
{
    double worst = s->variance / s->variance_bound;
    if (s->p_bound <= NO_PROMISE) {
        worst = fmax(worst, s->p_error / s->p_bound);
    }
    if (s->guarded_bound <= NO_PROMISE) {
        worst = fmax(worst, s->guarded_error / s->guarded_bound);
    }
    worst = s->below > LAST_ROUNDINGS ? fmax(worst, 1 + s->below) : worst;
    return sample_holds(s) ? worst : fmax(worst, 1.0000001);
}

static int fuzz(const Options *options)
{
    Random random = {options->seed};
    long failures = 0;
    long at_4u = 0;
    double worst = 0;
    Chain worst_chain = {0};
    static Window window, worst_window;
    Sample worst_sample = {.p_error = 0};
    if (options->what == SAMPLES) {
        printf("format,taps,condition,error_bits,bound_bits\n");
    }
    for (long i = 0; i < options->count; i++) {
        Chain chain = random_chain(&random, options->fault);
        random_window(&random, &chain, &window);
        Sample sample = measure(&chain, &window);
        failures += !sample_holds(&sample);
        at_4u += sample.at_4u > LAST_ROUNDINGS;
        if (severity(&sample) > worst) {
            worst = severity(&sample);
            worst_chain = chain;
            worst_window = window;
            worst_sample = sample;
        }
        if (options->what == SAMPLES) {
            print_sample(&chain, &sample);
        }
    }
    if (options->what != SAMPLES) {
        printf("%ld windows, %ld beyond the bound, largest part of it %.3f\n",
               options->count, failures, worst);
        printf("below the lit share with 4 u M2: %ld\n", at_4u);
    }
    if (failures > 0) {
        print_failure(&worst_chain, &worst_window, &worst_sample);
    }
    return failures > 0;
}

int main(int count, char **words)
{
    Options options = read_options(count, words);
    switch (options.what) {
    case SHADOWS:
        print_shadow_table();
        return 0;
    case CLOSED_FORM:
        print_closed_form();
        return 0;
    case CASES:
        print_case_rows(options.fault);
        return 0;
    default:
        return fuzz(&options);
    }
}
