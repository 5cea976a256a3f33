#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"
#include "step3_moments/techniques/shared/shared.h" // moments_merged

static struct {
    const char *moments; // raw or central
} settings = {"raw"};

static const Option options[] = {
    {.name = "moments",
     .kind = OPTION_CHOICE,
     .choices = "raw,central",
     .help = "what a texel holds: E[x] and E[x^2] of its depths x, or their "
             "mean and variance; step 5 takes central ones by itself with "
             "--format rg16f, --mips and --soft"},
    {0},
};

static bool prepare(Frame *frame)
{
    static const char *const merge[] = {
        "step3_moments/techniques/central/merge_central.glsl", NULL};
    static const char *const between[] = {
        "step3_moments/techniques/central/between_central.glsl", NULL};
    static const char *const half[] = {
        "step3_moments/techniques/central/store_half.glsl", NULL};
    static const char *const show[] = {
        "step3_moments/techniques/central/show_variance_merged.glsl", NULL};
    Shaders *shaders = &frame->shaders;
    if (strcmp(settings.moments, "central") != 0) {
        return false;
    }
    gl_put_instead(shaders, "step3_moments/shaders/moments.frag",
                   moments_merged);
    gl_put_instead(shaders, "step3_moments/shaders/lookup_bilinear.glsl",
                   lookup_between);
    gl_put_instead(shaders, "step3_moments/techniques/shared/merge_raw.glsl",
                   merge);
    gl_put_instead(shaders, "step3_moments/techniques/shared/between_raw.glsl",
                   between);
    gl_put_instead(shaders, "step3_moments/shaders/show_variance.glsl", show);
    if (options_is(frame->options, "format", "rg16f")) {
        gl_put_instead(
            shaders, "step3_moments/techniques/shared/store_float.glsl", half);
    }
    return true;
}

// A variance is no weighted mean of variances, so the texture unit may not
// average any. Far depth does not vary.
static void create(Frame *frame, Picture *picture)
{
    static const Sampling single = {GL_NEAREST, {1, 0, 1, 1}};
    (void)picture;
    for (int i = 0; i < frame->targets.count; i++) {
        if (frame->targets.list[i]->kind == TARGET_LAYERS) {
            frame->targets.list[i]->sampling = single;
        }
    }
}

const Technique moments_central = {.options = options,
                                   .settings = &settings,
                                   .prepare = prepare,
                                   .create = create};
