#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h" // die_usage
#include "step1_shadowmap/techniques/shared/footprint.h"

static struct {
    const char *width; // of a table's box: fixed or adaptive
} settings = {"fixed"};

static const Option options[] = {
    {.name = "sat-width",
     .kind = OPTION_CHOICE,
     .choices = "fixed,adaptive",
     .help =
         "with --sat: the box is 2 radius + 1 texels wide, or up to that as "
         "many as a texel is half pixels wide"},
    {0},
};

static void check(Frame *frame)
{
    if (options_given(frame->options, "sat-width") &&
        !options_on(frame->options, "sat")) {
        die_usage("--sat-width %s is of a summed-area table's box: add --sat "
                  "or drop --sat-width",
                  settings.width);
    }
}

static bool prepare(Frame *frame)
{
    static const char *const adaptive[] = {
        map_footprint_steps, map_footprint_file,
        "step5_chebyshev/techniques/sat_width/lookup_sat_adaptive.glsl", NULL};
    if (strcmp(settings.width, "adaptive") != 0) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step4_blur/techniques/sat/lookup_sat.glsl",
                   adaptive);
    return true;
}

const Technique chebyshev_sat_width = {.options = options,
                                       .settings = &settings,
                                       .check = check,
                                       .prepare = prepare};
