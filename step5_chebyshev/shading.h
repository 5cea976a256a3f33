// Step 5: which of the ways to shade a picture were asked for, and the shader
// files that they are made of.
#ifndef STEP5_SHADING_H
#define STEP5_SHADING_H

#include "step1_shadowmap/base/picture/scene_draw.h" // SceneDraw
#include "step3_moments/moments.h"                   // MomentsSettings
#include "step4_blur/blur.h"                         // BlurSettings
#include "step5_chebyshev/chebyshev.h"               // ChebyshevSettings
#include "step5_chebyshev/soft.h"                    // SoftSettings

typedef struct ShadingSettings {
    MomentsSettings moments; // of the stages that the picture stands on
    BlurSettings blur;
    ChebyshevSettings chebyshev;
    bool deferred;         // what each pixel shows first, then its light
    const char *sat_width; // of a table's box: fixed or adaptive
    bool soft;             // the penumbra is each receiver's own
    SoftSettings softness;
    bool hybrid; // comparisons in its penumbra, not moments
    int reach;   // texels that a lookup reads to each side; 0: not known yet
    char constants[CHEBYSHEV_CONSTANTS_BYTES]; // of shading_constants
} ShadingSettings;

extern const Option shading_options[];

// The defaults of the stages before, but for central moments: only their
// rounding is so small that what is added against it leaves a shadow dark.
ShadingSettings shading_settings(void);

// Chooses what the filter needs. Soft shadows: mip-maps, of moments that are
// not blurred unless a blur was asked for. A filter that takes sums or means of
// whatever a texel holds: raw moments, unless --moments was given. Then refuses
// (status 2) what moments_settings_check (see there) and blur_check
// do, and what contradicts that filter.
void shading_check(ShadingSettings *settings, BaseSettings *base,
                   const OptionTable tables[]);

// facts_collect with room for the widest lookup, which it finds the first time,
// and blur_plan_decide. Soft shadows look all of a layer up where
// they look it up.
void shading_look(ShadingSettings *settings, BlurPlan *plan, Facts *facts,
                  Views *views, const Scene *scene, const BaseSettings *base);

enum { SHADING_MAX_SHADERS = BLUR_MAX_SHADERS + 5 };

// The shader files that define visibility() for these settings, up to
// SHADING_MAX_SHADERS with the NULL at the end.
void shading_shaders(const ShadingSettings *settings, const char *files[]);

// What these files take for constants (see ShaderFiles), once the map's filter
// exists; NULL if there is no map. A shader reads them in less time than
// uniforms: Mesa's software driver gathers each number of a uniform for every
// pixel. Valid as long as the settings.
const char *shading_constants(ShadingSettings *settings, const Blur *filter);

// The picture that these files and the scene's light make, see
// scene_draw_create.
SceneDraw shading_picture(const ShadingSettings *settings,
                          const BaseSettings *base, Facts *facts);

// Sets the uniforms of these files, but those of the filter's own lookup.
void shading_apply(const ShadingSettings *settings, const Views *views,
                   GLuint program);

#endif
