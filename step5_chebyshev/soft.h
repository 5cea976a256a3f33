// Step 5, --soft: penumbrae that grow with the way from what casts them.
#ifndef STEP5_SOFT_H
#define STEP5_SOFT_H

#include "step1_shadowmap/base/light/view.h" // Views
#include "step4_blur/blur.h"                 // BlurSettings

typedef struct SoftSettings {
    double light_size; // its diameter, world units; of a parallel light at a
                       // distance of 1: the tangent of its angle
    double penumbra_scale;
} SoftSettings;

// Lookups that are averaged for a pixel: POISSON_TAPS of poisson_disc.glsl.
enum { SOFT_TAPS = 32 };

// How many texels of the full map the widest search reads to each side, with
// the blur before it: what views_fit is to leave room for. At most an eighth of
// the map, else most of it would hold what nobody sees.
int soft_reach(const SoftSettings *settings, const BlurSettings *blur,
               const Frame *frame);

// Sets the uniforms of penumbra.glsl; `projected` is how t is made. The program
// is in use.
void soft_apply(const SoftSettings *settings, const Views *views,
                bool projected, GLuint program);

#endif
