// Hill climbing for the window that is as wrong as the bound allows: a bound
// that nothing comes near is merely generous.

#ifndef STABILITY_SEARCH_H
#define STABILITY_SEARCH_H

#include "tests/stability/windows.h" // Chain, Window

#define NO_PROMISE 0.1 // a larger bound says nothing about a visibility

// What is compared with long double, and with its bound.
typedef enum Quantity { OF_P, OF_VARIANCE } Quantity;

// A window, and what it may become.
typedef struct Place {
    Window window;
    double low, high; // of all depths; t: from low to high and `reach` more
    double reach;     // no depth moves further than this from where it was
} Place;

typedef struct SearchCase {
    Chain chain; // format, raw or central, filter
    Quantity quantity;
    bool guarded; // with `auto`, or with nothing added
    int steps;    // tries; 2000 take about 0.1 s at 7 taps
    uint64_t seed;
    // Where to start: sets the place, another one each time.
    void (*start)(const void *context, Random *random, Place *place);
    const void *context;
} SearchCase;

typedef struct Measured {
    double error; // |p - exact p|, or of the variance
    double bound; // of p: above NO_PROMISE: no promise
    double ratio;
    bool finite;
} Measured;

Measured measure_window(const Chain *chain, Quantity quantity, bool guarded,
                        const Window *window);

// The largest ratio found, among windows whose bound is a promise; 0 if there
// are none.
double search_worst(const SearchCase *search);

#endif
