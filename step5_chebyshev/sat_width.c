#include "step5_chebyshev/sat_width.h"

#include <string.h> // memmove, strcmp

#include "step1_shadowmap/base/die.h"        // die_usage
#include "step1_shadowmap/base/scene_draw.h" // scene_draw_footprint

const Option sat_width_options[] = {
    {.name = "sat-width",
     .kind = OPTION_CHOICE,
     .offset = offsetof(SatWidthSettings, width),
     .choices = "fixed,adaptive",
     .help =
         "with --sat: the box is 2 radius + 1 texels wide, or up to that as "
         "many as a texel is half pixels wide"},
    {0},
};

SatWidthSettings sat_width_settings(void)
{
    return (SatWidthSettings){.width = "fixed"};
}

void sat_width_check(const BlurSettings *blur, const OptionTable tables[])
{
    if (options_given(tables, "sat-width") && !blur->sat) {
        die_usage("--sat-width is of a summed-area table's box: add --sat or "
                  "drop --sat-width");
    }
}

void sat_width_shaders(const SatWidthSettings *settings,
                       const char *files[SAT_WIDTH_MAX_SHADERS])
{
    if (strcmp(settings->width, "adaptive") != 0) {
        return;
    }
    int count = 0, place = 0;
    for (; files[count] != NULL; count++) {
        if (strcmp(files[count], blur_sat_lookup) == 0) {
            place = count;
        }
    }
    memmove(&files[place + 1], &files[place],
            sizeof *files * (size_t)(count + 1 - place));
    files[place] = scene_draw_footprint;
    files[place + 1] = "step5_chebyshev/shaders/lookup_sat_adaptive.glsl";
}
