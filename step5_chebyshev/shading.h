// Step 5: which of the ways to shade a picture were asked for, and the shader
// files that they are made of.
#ifndef STEP5_SHADING_H
#define STEP5_SHADING_H

#include "step4_blur/blur.h"           // BLUR_MAX_SHADERS
#include "step5_chebyshev/chebyshev.h" // ChebyshevSettings

typedef struct ShadingSettings {
    bool deferred;         // what each pixel shows first, then its light
    const char *sat_width; // of a table's box: fixed or adaptive
} ShadingSettings;

extern const Option shading_options[];

ShadingSettings shading_settings(void);

// Refuses (status 2) what blur_settings_check does, and what contradicts the
// filter that is left.
void shading_settings_check(const ShadingSettings *settings,
                            const BlurSettings *blur,
                            const MomentsSettings *moments,
                            const int map_size[2], const OptionTable tables[]);

enum { SHADING_MAX_SHADERS = BLUR_MAX_SHADERS + 3 };

// The shader files that define visibility() for these settings, up to
// SHADING_MAX_SHADERS with the NULL at the end.
void shading_shaders(const ShadingSettings *settings, const BlurSettings *blur,
                     const MomentsSettings *moments,
                     const ChebyshevSettings *chebyshev, const char *files[]);

#endif
