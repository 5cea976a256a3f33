#include "step1_shadowmap/base/seams/technique.h"

static struct {
    bool asked; // each tap is a weighted mean of 2 x 2 comparisons
} settings;

static const Option options[] = {
    {.name = "bilinear",
     .kind = OPTION_FLAG,
     .help = "each comparison a weighted mean of 2 x 2, without steps"},
    {0},
};

// No pattern but the lesson's is known to keep a lone plane lit.
static bool prepare(Frame *frame)
{
    static const char *const files[] = {
        "step2_pcf/techniques/adaptive/width_fixed.glsl",
        "step2_pcf/techniques/bilinear/pcf_bilinear.glsl", NULL};
    if (!settings.asked) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step2_pcf/shaders/pcf.glsl", files);
    frame->lookups.kernel = 0;
    return true;
}

const Technique pcf_bilinear = {
    .options = options, .settings = &settings, .prepare = prepare};
