#include "step5_chebyshev/shading.h"

#include <string.h> // memmove, strcmp

#include "step1_shadowmap/base/die.h"        // die_usage
#include "step1_shadowmap/base/scene_draw.h" // scene_draw_footprint

const Option shading_options[] = {
    {.name = "deferred",
     .kind = OPTION_FLAG,
     .offset = offsetof(ShadingSettings, deferred),
     .help =
         "store what each pixel shows in a G-buffer, then shade every pixel "
         "once"},
    {.name = "sat-width",
     .kind = OPTION_CHOICE,
     .offset = offsetof(ShadingSettings, sat_width),
     .choices = "fixed,adaptive",
     .help =
         "with --sat: the box is 2 radius + 1 texels wide, or up to that as "
         "many as a texel is half pixels wide"},
    {0},
};

ShadingSettings shading_settings(void)
{
    return (ShadingSettings){.sat_width = "fixed"};
}

void shading_settings_check(const ShadingSettings *settings,
                            const BlurSettings *blur,
                            const MomentsSettings *moments,
                            const int map_size[2], const OptionTable tables[])
{
    blur_settings_check(blur, moments, map_size, tables);
    if (options_given(tables, "sat-width") && !blur->sat) {
        die_usage("--sat-width %s is of a summed-area table's box: add --sat "
                  "or drop --sat-width",
                  settings->sat_width);
    }
}

// Puts the adaptive box's lookup, and the footprint that this one asks for, in
// place of the fixed box's.
static void adapt_box(const char *files[])
{
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

void shading_shaders(const ShadingSettings *settings, const BlurSettings *blur,
                     const MomentsSettings *moments,
                     const ChebyshevSettings *chebyshev, const char *files[])
{
    int count = 1;
    files[0] = chebyshev_reduction_shader(chebyshev);
    blur_picture_shaders(blur, moments,
                         chebyshev_guard_shader(chebyshev, moments), &files[1]);
    while (files[count] != NULL) {
        count++;
    }
    files[count] = "step5_chebyshev/shaders/chebyshev.glsl";
    files[count + 1] = NULL;
    if (strcmp(settings->sat_width, "adaptive") == 0) {
        adapt_box(files);
    }
}
