#include "step1_shadowmap/base/picture/picture.h" // picture_footprint
#include "step1_shadowmap/base/run/technique.h"

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
static void prepare(Frame *frame)
{
    static const char *const width[] = {
        picture_footprint, "step1_shadowmap/shaders/ellipse.glsl",
        "step2_pcf/techniques/adaptive/width_adaptive.glsl", NULL};
    static const char *const filter[] = {
        "step2_pcf/techniques/adaptive/width_fixed.glsl",
        "step2_pcf/techniques/adaptive/pcf_adaptive.glsl", NULL};
    if (settings.asked) {
        gl_put_instead(&frame->shaders, "step2_pcf/shaders/pcf.glsl", filter);
        gl_put_instead(&frame->shaders, filter[0], width);
        frame->lookups.kernel = 0;
    }
}

const Technique pcf_adaptive = {options, &settings, NULL, prepare};
