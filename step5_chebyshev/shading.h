// Step 5: which of the ways to shade a picture were asked for, and the shader
// files that they are made of.
#ifndef STEP5_SHADING_H
#define STEP5_SHADING_H

#include "step1_shadowmap/base/picture/picture.h" // Picture
#include "step3_moments/moments.h"                // MomentsSettings
#include "step4_blur/blur.h"                      // BlurSettings
#include "step5_chebyshev/chebyshev.h"            // ChebyshevSettings
#include "step5_chebyshev/soft.h"                 // SoftSettings

typedef struct ShadingSettings {
    MomentsSettings moments; // of the stages that the picture stands on
    BlurSettings blur;
    ChebyshevSettings chebyshev;
    bool deferred;         // what each pixel shows first, then its light
    const char *sat_width; // of a table's box: fixed or adaptive
    bool soft;             // the penumbra is each receiver's own
    SoftSettings softness;
    bool hybrid;             // comparisons in its penumbra, not moments
    const char *why_moments; // are central or raw, for --plan
    Target told;             // the row of --plan
    char constants[CHEBYSHEV_CONSTANTS_BYTES]; // of shading_constants
} ShadingSettings;

extern const Option shading_options[];

ShadingSettings shading_settings(void);

// Chooses what the filter needs. Soft shadows: mip-maps, of moments that are
// not blurred unless a blur was asked for. 16 bits and mip-maps: central
// moments, unless --moments was given, or a table or the texture unit takes
// sums or means of whatever a texel holds. Then refuses (status 2) what
// moments_settings_check (see there) and blur_check do, and what contradicts
// that filter.
void shading_check(ShadingSettings *settings, BaseSettings *base,
                   const OptionTable tables[]);

// The picture's lookups in a scene; soft shadows may look anywhere in a layer.
Lookups shading_lookups(const ShadingSettings *settings, const Frame *frame);

enum { SHADING_MAX_SHADERS = BLUR_MAX_SHADERS + 5 };

// The shader files that define visibility() for these settings, up to
// SHADING_MAX_SHADERS with the NULL at the end.
void shading_shaders(const ShadingSettings *settings, const char *files[]);

// The picture that these files and the scene's light make of the filtered map,
// see picture_create. What the files take for constants is known then: a shader
// reads them in less time than uniforms, for Mesa's software driver gathers
// each number of a uniform for every pixel.
void shading_picture(ShadingSettings *settings, Picture *picture, Frame *frame,
                     Blur *filter);

// Sets the uniforms of these files, but those of the filter's own lookup. The
// program is in use.
void shading_apply(const ShadingSettings *settings, const Views *views,
                   GLuint program);

#endif
