// Step 5: from filtered moments to a bound on how much light arrives.
#ifndef STEP5_CHEBYSHEV_H
#define STEP5_CHEBYSHEV_H

#include "step1_shadowmap/base/system/options.h" // Option
#include "step3_moments/moments.h"               // MomentsSettings
#include "step5_chebyshev/guard.h"               // GuardNumbers

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

// The one that says what variance and distance go into the bound.
const char *chebyshev_guard_shader(const ChebyshevSettings *settings,
                                   const MomentsSettings *moments);

enum { CHEBYSHEV_CONSTANTS_BYTES = 320 };

// What chebyshev.glsl and these two take for constants, in GLSL.
void chebyshev_constants(const ChebyshevSettings *settings,
                         const GuardNumbers *guard,
                         char text[CHEBYSHEV_CONSTANTS_BYTES]);

#endif
