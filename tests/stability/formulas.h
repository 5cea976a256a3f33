// The formulas of steps 3 to 5 on one small window of depths: as the shaders
// compute them, rounding after every operation, and in long double.

#ifndef STABILITY_FORMULAS_H
#define STABILITY_FORMULAS_H

#include <stdbool.h> // bool

enum { MAX_TAPS = 129, MAX_SIDE = 2 * (MAX_TAPS + 1) };

// How a texel keeps a number. What it stores is z (1 + d) + e with
// |d| <= roundoff and |e| <= tiny (where z is below the normal numbers).
typedef struct Format {
    const char *name;
    int digits; // significant bits; 24: stores are exact, as z is a float
    bool truncates;
    double roundoff;
    double tiny;
} Format;

enum { FP32, FP16, FP16_TRUNCATED, FORMATS };
extern const Format formats[FORMATS];

// Mistakes to plant, so that the fuzzing is seen to find them.
typedef enum Fault {
    NO_FAULT,
    VARIANCE_SIGN,
    NAIVE_MERGE,
    BOUND_TENTH,
    BOUND_TENFOLD
} Fault;

// How 2 x 2 texels become one: two at a time, along one axis and then along the
// other (raw a + w (b - a), as a texture unit does it; central without
// cancellation), or not at all.
typedef enum Lookup { LOOKUP_BILINEAR, LOOKUP_NONE } Lookup;

// What happens to depths between the map and the bound: the mean of factor x
// factor texels, a blur along u and one along v, a bilinear lookup.
typedef struct Chain {
    const Format *format;
    bool central; // texels hold mean and variance, not M1 and M2
    Lookup lookup;
    int factor; // 1: no downsampling
    int taps;   // of the blur, along each axis; 1: no blur
    float weights[MAX_TAPS];
    float across, up; // where the lookup is between 2 x 2 texels, 0 to 1
    Fault fault;
} Chain;

// Depths in [0, 1], side x side of them, side = chain_side(), row by row.
typedef struct Window {
    float depths[MAX_SIDE * MAX_SIDE];
    float t; // the receiver's depth
} Window;

// What the minimum variance `auto` adds; proof.md derives it. All 0: nothing.
typedef struct Guard {
    float variance;   // raw: of M2; central: of sqrt(M2), to the deviation
    float deviation;  // central: of the deviation
    float mean;       // t - M1 shrinks by this much of M1
                      // (central: M1 and sqrt(M2) count as 1/2 at most)
    float tiny;       // whatever the moments: added to the variance
    float tiny_shift; // and to the shrinking (central: and the deviation)
} Guard;

typedef struct Estimate {
    float mean;
    float variance; // not below 0, nothing added
    float p;        // with the guard
} Estimate;

typedef struct Exact {
    double mean, variance, m2;
    double behind;     // t - mean
    double p;          // of Cantelli's bound, nothing added
    double lit;        // the weights of all depths at or behind t
    double most_depth; // the largest depth
} Exact;

// Blurred texels along an axis that the lookup reads: 2, or 1 without one.
int chain_corners(const Chain *chain);
// Texels of the map along an axis that the whole chain reads.
int chain_side(const Chain *chain);
float format_store(const Format *format, float value);

// exact() takes the depths as the texels hold them, that is, stored.
Estimate estimate(const Chain *chain, const Window *window, const Guard *guard);
Exact exact(const Chain *chain, const Window *window);

#endif
