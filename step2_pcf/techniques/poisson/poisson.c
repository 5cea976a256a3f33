#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h" // die_usage

static struct {
    const char *pattern; // grid or poisson
} settings = {"grid"};

static const Option options[] = {
    {.name = "pattern",
     .kind = OPTION_CHOICE,
     .choices = "grid,poisson",
     .help = "where the comparisons are: at every texel, or at 32 points of a "
             "disc that each pixel turns"},
    {0},
};

static bool is_asked(void)
{
    return strcmp(settings.pattern, "poisson") == 0;
}

static void check(Frame *frame)
{
    if (is_asked() && options_given(frame->options, "bilinear")) {
        die_usage("--bilinear weights the taps of a grid, and --pattern "
                  "poisson has none: drop one of them");
    }
}

static bool prepare(Frame *frame)
{
    static const char *const files[] = {
        "step2_pcf/techniques/adaptive/width_fixed.glsl",
        "step2_pcf/techniques/poisson/poisson_disc.glsl",
        "step2_pcf/techniques/poisson/pcf_poisson.glsl", NULL};
    if (!is_asked()) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step2_pcf/shaders/pcf.glsl", files);
    frame->lookups.kernel = 0;
    return true;
}

const Technique pcf_poisson = {.options = options,
                               .settings = &settings,
                               .check = check,
                               .prepare = prepare};
