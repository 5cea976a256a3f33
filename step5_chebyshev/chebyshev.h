// Step 5: from filtered moments to a bound on how much light arrives.
#ifndef STEP5_CHEBYSHEV_H
#define STEP5_CHEBYSHEV_H

#include "step1_shadowmap/base/system/options.h" // Option

typedef struct ChebyshevSettings {
    double min_variance;    // of the squared depth range, or OPTION_AUTO
    double bleed_reduction; // A in [0, 1)
} ChebyshevSettings;

extern const Option chebyshev_options[];

ChebyshevSettings chebyshev_settings(void);

// The guard is what we add against rounding, with --min-variance auto: the most
// that rounding can have changed the variance and the mean. Each is a part of a
// moment, and a constant.
typedef struct GuardNumbers {
    float variance[2]; // the part of M2
    float mean[2];     // the part of M1
} GuardNumbers;

// These numbers of moments that are downsampled by a factor, blurred along both
// axes and looked up bilinearly.
GuardNumbers chebyshev_guard(int radius, int factor);

// The variance of the weights of such a box filter, in square texels of the
// full map, if the guard is that of chebyshev_guard(); else 0. It is for
// Lookups.spread in base/picture/frame.h.
double chebyshev_spread(const ChebyshevSettings *settings, int radius,
                        int factor);

enum { CHEBYSHEV_CONSTANTS_BYTES = 256 };

// What visibility.glsl and reduction_linear.glsl take for constants. (A shader
// reads them in less time than uniforms.)
void chebyshev_constants(const ChebyshevSettings *settings, int radius,
                         int factor, char text[CHEBYSHEV_CONSTANTS_BYTES]);

#endif
