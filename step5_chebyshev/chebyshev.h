// Step 5: from filtered moments to a bound on how much light arrives.
#ifndef STEP5_CHEBYSHEV_H
#define STEP5_CHEBYSHEV_H

#include <glad/gl.h> // GLenum, GLuint

#include "step1_shadowmap/base/options.h" // Option

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

// Sets the uniforms of chebyshev.glsl; `format` is what the moments are
// stored in: its unit roundoff gives the automatic minimum variance.
void chebyshev_apply(const ChebyshevSettings *settings, GLenum format,
                     GLuint program);

#endif
