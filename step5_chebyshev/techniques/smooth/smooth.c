#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"

static struct {
    const char *reduction; // linear or smooth
} settings = {"linear"};

static const Option options[] = {
    {.name = "reduction",
     .kind = OPTION_CHOICE,
     .choices = "linear,smooth",
     .help = "how what is above the bleed reduction is stretched"},
    {0},
};

static bool prepare(Frame *frame)
{
    static const char *const smooth[] = {
        "step5_chebyshev/techniques/smooth/reduction_smooth.glsl", NULL};
    if (strcmp(settings.reduction, "smooth") != 0) {
        return false;
    }
    gl_put_instead(&frame->shaders,
                   "step5_chebyshev/shaders/reduction_linear.glsl", smooth);
    return true;
}

const Technique chebyshev_smooth = {
    .options = options, .settings = &settings, .prepare = prepare};
