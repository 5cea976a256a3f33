// Step 5: from filtered moments to a bound on how much light arrives.
#ifndef STEP5_CHEBYSHEV_H
#define STEP5_CHEBYSHEV_H

#include "step1_shadowmap/base/system/options.h" // Option

typedef struct ChebyshevSettings {
    double min_variance;    // of the squared depth range, or OPTION_AUTO
    double variance_bias;   // added to every variance, same unit
    double bleed_reduction; // A in [0, 1)
    const char *reduction;  // linear or smooth
} ChebyshevSettings;

extern const Option chebyshev_options[];

ChebyshevSettings chebyshev_settings(void);

// The shader file that defines reduce_bleeding() for these settings.
const char *chebyshev_reduction_shader(const ChebyshevSettings *settings);

// --min-variance auto: the most that rounding can have changed the variance and
// the mean. See guard_raw.glsl; guard_central.glsl takes them differently.
typedef struct GuardNumbers {
    float variance[2]; // the part of M2, and a constant
    float mean[2];     // the part of M1, and a constant
    float spread;      // of central moments
} GuardNumbers;

// These numbers of raw moments in 32 bits that are downsampled by a factor,
// blurred along both axes and looked up bilinearly.
GuardNumbers chebyshev_guard(int radius, int factor);

enum { CHEBYSHEV_CONSTANTS_BYTES = 320 };

// What chebyshev.glsl and these two take for constants, in GLSL.
void chebyshev_constants(const ChebyshevSettings *settings,
                         const GuardNumbers *guard,
                         char text[CHEBYSHEV_CONSTANTS_BYTES]);

#endif
