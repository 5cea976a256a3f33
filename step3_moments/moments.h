// Step 3: two moments of the depth in place of the depth.
#ifndef STEP3_MOMENTS_H
#define STEP3_MOMENTS_H

#include "step1_shadowmap/base/legend.h"  // ShowMode
#include "step1_shadowmap/base/options.h" // Option
#include "step1_shadowmap/shadow_map.h"   // ShadowMap

typedef struct MomentsSettings {
    const char *format;
    const char *depth; // linear or projected
} MomentsSettings;

extern const Option moments_options[];

// --show mean and --show variance.
extern const ShowMode moments_shows[];

MomentsSettings moments_settings(void);

// The shader file with the formula of the depth t, for the map and the picture.
const char *moments_depth_shader(const MomentsSettings *settings);

// The OpenGL format that the moments are stored in.
GLenum moments_format(const MomentsSettings *settings);

// A shadow map of two channels, M1 = t and M2 = t^2, looked up bilinearly:
// unlike depths, moments may be averaged. shadow_map_draw fills it.
ShadowMap moments_create(ShaderFiles files, const Views *views,
                         const MomentsSettings *settings);

#endif
