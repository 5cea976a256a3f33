// The averages that these settings make, in their order.
#include "step5_chebyshev/guard_settings.h"

#include <stdlib.h> // free

#include "step1_shadowmap/base/system/die.h" // allocate

// One filter of the blur. Its weights are rounded, each by a part of itself: so
// is their sum. Running boxes round no more often: a term meets as many
// additions, and the division in place of the weight.
static void add_filter(GuardChain *chain, const char *kernel,
                       const int sides[2])
{
    int taps = sides[0] + 1 + sides[1];
    float *weights = allocate((size_t)taps, sizeof *weights);
    blur_weights(kernel, sides, weights);
    guard_add(chain, (GuardPass){.taps = taps,
                                 .heaviest = (double)weights[sides[0]],
                                 .defect = 0x1p-24,
                                 .stored = true});
    free(weights);
}

// Both axes of the blur.
static void add_blur(GuardChain *chain, const BlurSettings *settings)
{
    BlurSides filters[BLUR_MAX_FILTERS];
    int count = blur_filters(settings, filters);
    for (int i = 0; i < 2 * count; i++) {
        add_filter(chain, settings->kernel, filters[i % count].sides);
    }
}

// The coarsest level, for which there are the most passes; then between two
// levels, then the taps along the pixel or over the penumbra.
static void add_levels(GuardChain *chain, const Blur *filter, int lookups)
{
    for (int level = 1; level < filter->mips.levels; level++) {
        guard_add(chain, (GuardPass){
                             .taps = 16, .heaviest = 9.0 / 64, .stored = true});
    }
    guard_add_bilinear(chain);
    guard_add(chain, (GuardPass){.two = true});
    if (lookups > 1) {
        guard_add_box(chain, lookups);
        chain->passes[chain->count - 1].stored = false;
    }
}

GuardNumbers guard_of_settings(const MomentsSettings *moments,
                               const BlurSettings *settings, const Blur *filter,
                               int lookups)
{
    GuardChain chain = {.central = moments_are_central(moments)};
    if (moments_format(moments) == GL_RG16F) {
        // Raw moments are left to the driver, which may cut them off.
        chain.store_roundoff = chain.central ? 0x1p-11 : 0x1p-10;
        chain.store_tiny = chain.central ? 0x1p-25 : 0x1p-24;
    }
    if (moments->msaa > 1) {
        guard_add_box(&chain, moments->msaa);
    }
    if (settings->downsample > 1) {
        guard_add_box(&chain, settings->downsample * settings->downsample);
    }
    if (settings->sat) {
        chain.table_error = 0.5 / filter->sat.steps + 24 * 0x1p-24;
        return guard_numbers(&chain);
    }
    add_blur(&chain, settings);
    if (settings->mips) {
        add_levels(&chain, filter, lookups);
    } else {
        guard_add_bilinear(&chain);
    }
    return guard_numbers(&chain);
}
