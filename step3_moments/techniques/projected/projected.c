#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"

static struct {
    const char *depth; // linear or projected
} settings = {"linear"};

static const Option options[] = {
    {.name = "depth",
     .kind = OPTION_CHOICE,
     .choices = "linear,projected",
     .help = "the depth of a spot or point light: its distance, or z / w of "
             "the view; the same for a parallel light"},
    {0},
};

static bool prepare(Frame *frame)
{
    static const char *const depth[] = {
        "step3_moments/techniques/projected/projected_depth.glsl", NULL};
    if (strcmp(settings.depth, "projected") != 0) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step1_shadowmap/shaders/linear_depth.glsl",
                   depth);
    return true;
}

const Technique moments_projected = {
    .options = options, .settings = &settings, .prepare = prepare};
