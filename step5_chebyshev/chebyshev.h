// Step 5: from filtered moments to a bound on how much light arrives.
#ifndef STEP5_CHEBYSHEV_H
#define STEP5_CHEBYSHEV_H

#include <glad/gl.h> // GLuint

#include "step1_shadowmap/base/options.h" // Option
#include "step3_moments/moments.h"        // MomentsSettings
#include "step5_chebyshev/guard.h"        // GuardNumbers

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

// Sets the uniforms of chebyshev.glsl and of these two.
void chebyshev_apply(const ChebyshevSettings *settings,
                     const GuardNumbers *guard, GLuint program);

#endif
