#include "tests/stability/cases.h"

#include <math.h>  // fmax, pow
#include <stdio.h> // printf

#include "tests/stability/bound.h"       // p_bound
#include "tests/stability/search.h"      // search_worst
#include "tests/stability/step5_guard.h" // guard_of_step5

enum { WINDOWS = 1000 };
enum { SEARCH_STEPS = 2000, WIDE_SEARCH_STEPS = 200, WIDE = 33 };

// Depths on a few planes: a part of the texels, column by column, on each. The
// first plane is `base`, which is random; the others are nearer by these gaps.
typedef struct Planes {
    const Format *format;
    int side;
    double gaps[2];   // the second 0: two planes only
    double low, high; // of the base
} Planes;

static void start_planes(const void *context, Random *random, Place *place)
{
    const Planes *planes = context;
    int count = planes->gaps[1] > 0 ? 3 : 2;
    double base =
        planes->low + (planes->high - planes->low) * random_part(random);
    // Texels hold what the format can; the receiver is on the last plane.
    double depths[3] = {base, base - planes->gaps[0], base - planes->gaps[1]};
    for (int i = 0; i < planes->side * planes->side; i++) {
        int plane = i % planes->side * count / planes->side;
        place->window.depths[i] =
            format_store(planes->format, (float)depths[plane]);
    }
    place->window.t = place->window.depths[0];
    place->low = fmax(depths[count - 1], 0);
    place->high = base;
    place->reach = planes->gaps[0];
}

typedef struct Case {
    const char *name;
    double gap, far_gap; // see Planes
    double low, high;
    Kernel kernel;
    int taps;
    float across; // where the lookup is; 0.5: halves are exactly halves
} Case;

static Chain chain_of(const Case *c, const Format *format, bool central,
                      Fault fault)
{
    Chain chain = {.format = format,
                   .central = central,
                   .factor = 1,
                   .across = c->across,
                   .up = c->across,
                   .fault = fault};
    chain_set_kernel(&chain, c->kernel, c->taps, NULL);
    return chain;
}

typedef struct Row {
    Measured worst; // where the largest part of a bound is reached
    double largest; // error
    int promises, not_finite;
} Row;

static Row measure_row(const Chain *chain, const Planes *planes, bool guarded)
{
    static Place place;
    Random random = {1};
    Row row = {.largest = 0, .worst = {.ratio = -1}};
    int windows = chain->taps > WIDE ? WINDOWS / 20 : WINDOWS;
    for (int i = 0; i < windows; i++) {
        start_planes(planes, &random, &place);
        Measured m = measure_window(chain, OF_P, guarded, &place.window);
        row.largest = fmax(row.largest, m.error);
        row.not_finite += m.finite ? 0 : 1;
        row.promises += m.bound <= NO_PROMISE ? 1 : 0;
        if (!(m.ratio <= row.worst.ratio)) {
            row.worst = m;
        }
    }
    // A promise has to be one for every base.
    row.promises = row.promises == windows;
    return row;
}

static void print_row(const Case *c, const Chain *chain, bool guarded)
{
    Planes planes = {.format = chain->format,
                     .side = chain_side(chain),
                     .gaps = {c->gap, c->far_gap},
                     .low = c->low,
                     .high = c->high};
    Row row = measure_row(chain, &planes, guarded);
    SearchCase search = {.chain = *chain,
                         .quantity = OF_P,
                         .guarded = guarded,
                         .steps = chain->taps > WIDE ? WIDE_SEARCH_STEPS
                                                     : SEARCH_STEPS,
                         .seed = 1,
                         .start = start_planes,
                         .context = &planes};
    printf("%s,%s,%s,%s,%d,%.3g,%.3g,%.3g,%.3g,%d,", c->name,
           chain->format->name, chain->central ? "central" : "raw",
           guarded ? "auto" : "none", chain->taps, row.largest, row.worst.error,
           row.worst.bound, row.worst.ratio, row.not_finite);
    if (row.promises) {
        printf("%.3g\n", search_worst(&search));
    } else {
        printf("\n");
    }
}

static void print_case(const Case *c, Fault fault)
{
    for (int format = FP32; format < FORMATS; format++) {
        for (int central = 0; central < 2; central++) {
            Chain chain = chain_of(c, &formats[format], central == 1, fault);
            print_row(c, &chain, false);
            print_row(c, &chain, true);
        }
    }
}

void print_case_rows(Fault fault)
{
    static const Case shapes[] = {
        {"radius 0", 1e-2, 0, 0.5, 1, KERNEL_BOX, 1, 0.5F},
        {"radius 64", 1e-2, 0, 0.5, 1, KERNEL_BOX, 129, 0.5F},
        {"gaussian with weights from 1e-6 to 1", 1e-2, 0, 0.5, 1,
         KERNEL_WIDE_GAUSSIAN, 33, 0.375F},
        {"lookup beside the middle", 1e-2, 0, 0.5, 1, KERNEL_BOX, 7, 0.375F},
        {"gaps of 0.9 and 1e-5 under one filter", 1e-5, 0.9, 0.9, 1, KERNEL_BOX,
         7, 0.5F},
        {"depth near 0", 1e-3, 0, 1e-3, 2e-3, KERNEL_BOX, 7, 0.5F},
        {"a range stretched 1e4 times by one far caster", 1e-5, 0, 0.99995, 1,
         KERNEL_BOX, 7, 0.5F},
    };
    printf("case,format,moments,minimum,taps,largest,error,bound,ratio,"
           "nonfinite,searched\n");
    for (int decade = 1; decade <= 6; decade++) {
        char name[] = "gap 1e-0";
        name[sizeof name - 2] = (char)('0' + decade);
        Case gap = {name, pow(10, -decade), 0, 0.5, 1, KERNEL_BOX, 7, 0.5F};
        print_case(&gap, fault);
    }
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
        print_case(&shapes[i], fault);
    }
}

// A wall at 0.9 - gap over a receiver at 0.9: p should be 0, and is what step
// 5's `auto` leaves. Predicted: the bound's.
static void print_shadow(const Chain *chain, double gap)
{
    static Window window;
    Guard guard = guard_of_step5(chain);
    int side = chain_side(chain);
    for (int i = 0; i < side * side; i++) {
        window.depths[i] = (float)(0.9 - gap);
    }
    window.t = 0.9F;
    Exact truth = exact(chain, &window);
    Estimate bare = estimate(chain, &window, &(Guard){0});
    printf("%-14s %-7s %4d %7.0e %9.1e %9.1e %9.1e\n", chain->format->name,
           chain->central ? "central" : "raw", chain->taps, gap,
           (double)estimate(chain, &window, &guard).p,
           p_bound(chain, &truth, true),
           (double)p_at_least_4u(chain, &bare, window.t));
}

void print_shadow_table(void)
{
    const int taps[] = {7, 31}; // radius 3, the default, and 15
    printf("%-14s %-7s %4s %7s %9s %9s %9s\n", "format", "moments", "taps",
           "gap", "p left", "predicted", "4 u M2");
    for (int i = 0; i < FORMATS * 2 * 2; i++) {
        Case c = {.kernel = KERNEL_BOX, .taps = taps[i % 2], .across = 0.375F};
        Chain chain = chain_of(&c, &formats[i / 4], i / 2 % 2 == 1, NO_FAULT);
        for (int decade = 1; decade <= 6; decade++) {
            print_shadow(&chain, pow(10, -decade));
        }
    }
}
