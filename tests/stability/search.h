// Hill climbing for the window that is as wrong as the bound allows: a bound
// that nothing comes near is merely generous.

#ifndef STABILITY_SEARCH_H
#define STABILITY_SEARCH_H

#include "tests/stability/windows.h" // Chain, Window

#define NO_PROMISE 0.1 // a larger bound says nothing about a visibility

typedef struct SearchCase {
    Chain chain;    // format, raw or central, filter
    double nearest; // the depth range to stay in, within [0, 1]
    double farthest;
    double gap;   // between the two planes to start from
    bool guarded; // with `auto`, or with nothing added
    int steps;    // tries; 2000 take about 0.1 s at 5 taps
    uint64_t seed;
} SearchCase;

typedef struct SearchResult {
    double error; // |p - exact p| in the window of the largest ratio
    double bound; // predicted there; above NO_PROMISE: no promise
    double ratio;
    Window window;
} SearchResult;

// Two planes `gap` apart, then better ones. Windows whose bound is above
// NO_PROMISE are not searched; if even the first is one, it is returned.
SearchResult search_worst(const SearchCase *search);

#endif
