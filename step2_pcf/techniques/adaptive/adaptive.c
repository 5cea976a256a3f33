#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/techniques/shared/footprint.h"

static struct {
    bool asked; // n is the pixel's own, up to --kernel
} settings;

static const Option options[] = {
    {.name = "adaptive",
     .kind = OPTION_FLAG,
     .help = "each pixel's filter is as wide as the pixel is in the map: from "
             "3 texels to --kernel"},
    {0},
};

// In place of the lesson's filter or, where another technique has taken that
// place, of its width.
static bool prepare(Frame *frame)
{
    static const char *const width[] = {
        map_footprint_steps, map_footprint_file,
        "step1_shadowmap/techniques/shared/ellipse.glsl",
        "step2_pcf/techniques/adaptive/width_adaptive.glsl", NULL};
    static const char *const filter[] = {
        "step2_pcf/techniques/adaptive/width_fixed.glsl",
        "step2_pcf/techniques/adaptive/pcf_adaptive.glsl", NULL};
    if (!settings.asked) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step2_pcf/shaders/pcf.glsl", filter);
    gl_put_instead(&frame->shaders, filter[0], width);
    frame->lookups.kernel = 0;
    return true;
}

const Technique pcf_adaptive = {
    .options = options, .settings = &settings, .prepare = prepare};
