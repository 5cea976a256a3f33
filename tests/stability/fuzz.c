// Throws random depths at the formulas of steps 3 to 5 and holds their errors
// against the bound. `fuzz --help` lists what it can print.

#include <math.h>   // fabs
#include <stdio.h>  // printf
#include <stdlib.h> // strtol
#include <string.h> // strcmp

#include "tests/stability/bound.h"   // p_bound
#include "tests/stability/search.h"  // search_worst
#include "tests/stability/windows.h" // random_window

static const char usage[] =
    "fuzz [--count N] [--seed N] [--csv] [--break variance-sign|naive-merge]\n"
    "     checks N random windows; --csv prints each one's error\n"
    "fuzz --table   p left in full shadow by gap and format\n"
    "fuzz --search  the worst window that a search finds, by gap and format\n";

typedef struct Options {
    long count;
    unsigned long seed;
    bool csv;
    bool table;
    bool search;
    Fault fault;
} Options;

static void stop(const char *what)
{
    fprintf(stderr, "fuzz: %s\n%s", what, usage);
    exit(2);
}

static Fault fault_named(const char *name)
{
    if (strcmp(name, "variance-sign") == 0) {
        return VARIANCE_SIGN;
    }
    if (strcmp(name, "naive-merge") != 0) {
        stop("--break takes variance-sign or naive-merge");
    }
    return NAIVE_MERGE;
}

static Options read_options(int count, char **words)
{
    Options options = {.count = 2000, .seed = 1};
    for (int i = 1; i < count; i++) {
        const char *value = i + 1 < count ? words[i + 1] : "";
        bool takes_value = true;
        if (strcmp(words[i], "--count") == 0) {
            options.count = strtol(value, NULL, 10);
        } else if (strcmp(words[i], "--seed") == 0) {
            options.seed = strtoul(value, NULL, 10);
        } else if (strcmp(words[i], "--break") == 0) {
            options.fault = fault_named(value);
        } else {
            takes_value = false;
            options.csv |= strcmp(words[i], "--csv") == 0;
            options.table |= strcmp(words[i], "--table") == 0;
            options.search |= strcmp(words[i], "--search") == 0;
        }
        i += takes_value;
    }
    if (options.count < 1 ||
        (count == 2 && !options.csv && !options.table && !options.search)) {
        stop("what to do?");
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
    Kernel kernel = (Kernel)random_below(random, 3);
    chain_set_kernel(&chain, kernel, 1 + 2 * random_below(random, 8), random);
    return chain;
}

// What a window says. Ratios above 1 are failures.
typedef struct Sample {
    Exact truth;
    Estimate raw;     // nothing added
    Estimate guarded; // with `auto`
    double variance, variance_bound;
    double p_ratio;
    double guarded_ratio;
    double below; // how far p with `auto` is below the lit share
    double today; // and with 4 u M2
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
    s.p_ratio =
        fabs((double)s.raw.p - s.truth.p) / p_bound(chain, &s.truth, false);
    s.guarded_ratio =
        fabs((double)s.guarded.p - s.truth.p) / p_bound(chain, &s.truth, true);
    s.below = s.truth.lit - (double)s.guarded.p;
    s.today = s.truth.lit - (double)p_today(chain, &s.raw, window->t);
    return s;
}

static bool sample_holds(const Sample *s)
{
    // Comparisons with NaN are false: it does not hold.
    return s->p_ratio <= 1 && s->guarded_ratio <= 1 &&
           s->variance <= s->variance_bound && s->below <= LAST_ROUNDINGS;
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
           s->p_ratio, s->guarded_ratio, s->variance, s->variance_bound);
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

static double severity(const Sample *s)
{
    double worst = fmax(s->p_ratio, s->guarded_ratio);
    worst = fmax(worst, s->variance / s->variance_bound);
    worst = s->below > LAST_ROUNDINGS ? fmax(worst, 1 + s->below) : worst;
    return sample_holds(s) ? worst : fmax(worst, 1.0000001);
}

static int fuzz(const Options *options)
{
    Random random = {options->seed};
    long failures = 0;
    long today = 0;
    double worst = 0;
    Chain worst_chain = {0};
    static Window window, worst_window;
    Sample worst_sample = {.p_ratio = 0};
    if (options->csv) {
        printf("format,taps,condition,error_bits,bound_bits\n");
    }
    for (long i = 0; i < options->count; i++) {
        Chain chain = random_chain(&random, options->fault);
        random_window(&random, &chain, &window);
        Sample sample = measure(&chain, &window);
        failures += !sample_holds(&sample);
        today += sample.today > LAST_ROUNDINGS;
        if (severity(&sample) > worst) {
            worst = severity(&sample);
            worst_chain = chain;
            worst_window = window;
            worst_sample = sample;
        }
        if (options->csv) {
            print_sample(&chain, &sample);
        }
    }
    if (!options->csv) {
        printf("%ld windows, %ld beyond the bound, largest part of it %.4f\n",
               options->count, failures, worst);
        printf("below the lit share with 4 u M2: %ld\n", today);
    }
    if (failures > 0) {
        print_failure(&worst_chain, &worst_window, &worst_sample);
    }
    return failures > 0;
}

static Chain case_chain(int format, bool central, int taps)
{
    Chain chain = {.format = &formats[format],
                   .central = central,
                   .factor = 1,
                   .across = 0.375F,
                   .up = 0.625F};
    chain_set_kernel(&chain, KERNEL_BOX, taps, NULL);
    return chain;
}

// A wall at 0.9 - gap over a receiver at 0.9: p should be 0, and is what `auto`
// leaves. Predicted: its bound.
static void print_shadow(const Chain *chain, double gap)
{
    static Window window;
    Guard guard = guard_of(chain);
    int side = chain_side(chain);
    for (int i = 0; i < side * side; i++) {
        window.depths[i] = (float)(0.9 - gap);
    }
    window.t = 0.9F;
    Exact truth = exact(chain, &window);
    Estimate today = estimate(chain, &window, &(Guard){0});
    printf("%-14s %-7s %4d %7.0e %9.2g %9.2g %9.2g\n", chain->format->name,
           kind_of(chain), chain->taps, gap,
           (double)estimate(chain, &window, &guard).p,
           p_bound(chain, &truth, true),
           (double)p_today(chain, &today, window.t));
}

static void print_worst(const Chain *chain, double gap)
{
    SearchCase search = {.chain = *chain,
                         .nearest = 0.5,
                         .farthest = 1,
                         .gap = gap,
                         .steps = 2000,
                         .seed = 1};
    SearchResult worst = search_worst(&search);
    printf("%-14s %-7s %4d %7.0e %9.2g %9.2g ", chain->format->name,
           kind_of(chain), chain->taps, gap, worst.error, worst.bound);
    if (worst.bound > NO_PROMISE) {
        printf("no promise\n");
    } else {
        printf("%10.3f\n", worst.ratio);
    }
}

static void print_cases(void (*print)(const Chain *chain, double gap),
                        const int *taps)
{
    for (int format = FP32; format < FORMATS; format++) {
        for (int central = 0; central < 2; central++) {
            for (int i = 0; i < 2; i++) {
                Chain chain = case_chain(format, central == 1, taps[i]);
                for (int decade = 1; decade <= 6; decade++) {
                    print(&chain, pow(10, -decade));
                }
            }
        }
    }
}

int main(int count, char **words)
{
    Options options = read_options(count, words);
    if (options.table) {
        printf("%-14s %-7s %4s %7s %9s %9s %9s\n", "format", "moments", "taps",
               "gap", "p left", "predicted", "4 u M2");
        print_cases(print_shadow, (const int[]){5, 15});
        return 0;
    }
    if (options.search) {
        printf("%-14s %-7s %4s %7s %9s %9s %10s\n", "format", "moments", "taps",
               "gap", "error", "bound", "ratio");
        print_cases(print_worst, (const int[]){1, 5});
        return 0;
    }
    return fuzz(&options);
}
