// Step 3's --moments central in the filters of step 4.
#include "step1_shadowmap/base/seams/technique.h"

static bool prepare(Frame *frame)
{
    static const char *const blur[] = {
        "step3_moments/techniques/shared/merge_raw.glsl",
        "step3_moments/techniques/shared/store_float.glsl",
        "step4_blur/techniques/shared/blur_central.frag", NULL};
    static const char *const downsample[] = {
        "step3_moments/techniques/shared/merge_raw.glsl",
        "step3_moments/techniques/shared/store_float.glsl",
        "step4_blur/techniques/shared/downsample_central.frag", NULL};
    if (!options_is(frame->options, "moments", "central")) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step4_blur/shaders/blur.frag", blur);
    gl_put_instead(&frame->shaders, "step4_blur/shaders/downsample.frag",
                   downsample);
    return true;
}

const Technique blur_central = {.prepare = prepare};
