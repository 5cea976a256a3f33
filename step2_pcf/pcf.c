#include "step2_pcf/pcf.h"

#include <stdio.h>  // snprintf
#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h"      // die_usage
#include "step1_shadowmap/base/picture/picture.h" // picture_footprint

const Option pcf_options[] = {
    {.name = "kernel",
     .kind = OPTION_ODD,
     .offset = offsetof(PcfSettings, kernel),
     .minimum = 1,
     .maximum = 255,
     .argument = "N",
     .help = "filter width in texels of the map, N x N comparisons"},
    {.name = "pattern",
     .kind = OPTION_CHOICE,
     .offset = offsetof(PcfSettings, pattern),
     .choices = "grid,poisson",
     .help = "where the comparisons are: at every texel, or at 32 points of a "
             "disc that each pixel turns"},
    {.name = "bilinear",
     .kind = OPTION_FLAG,
     .offset = offsetof(PcfSettings, bilinear),
     .help = "each comparison a weighted mean of 2 x 2, without steps"},
    {.name = "adaptive",
     .kind = OPTION_FLAG,
     .offset = offsetof(PcfSettings, adaptive),
     .help = "each pixel's filter is as wide as the pixel is in the map: from "
             "3 texels to --kernel"},
    {0},
};

PcfSettings pcf_settings(void)
{
    return (PcfSettings){.kernel = 7, .pattern = "grid"};
}

static bool uses_disc(const PcfSettings *settings)
{
    return strcmp(settings->pattern, "poisson") == 0;
}

void pcf_settings_check(const PcfSettings *settings)
{
    if (settings->bilinear && uses_disc(settings)) {
        die_usage("--bilinear weights the taps of a grid, and --pattern "
                  "poisson has none: drop one of them");
    }
}

void pcf_shaders(const PcfSettings *settings, const char *files[])
{
    *files++ = "step1_shadowmap/shaders/depth_slope.glsl";
    *files++ = "step1_shadowmap/shaders/bias.glsl";
    *files++ = "step2_pcf/shaders/map_depth.glsl";
    if (settings->adaptive) {
        *files++ = picture_footprint;
        *files++ = "step1_shadowmap/shaders/ellipse.glsl";
        *files++ = "step2_pcf/shaders/width_adaptive.glsl";
    } else {
        *files++ = "step2_pcf/shaders/width_fixed.glsl";
    }
    if (uses_disc(settings)) {
        *files++ = "step2_pcf/shaders/poisson_disc.glsl";
        *files++ = "step2_pcf/shaders/pcf_poisson.glsl";
    } else {
        *files++ = settings->bilinear ? "step2_pcf/shaders/pcf_bilinear.glsl"
                                      : "step2_pcf/shaders/pcf.glsl";
    }
    *files = NULL;
}

Lookups pcf_lookups(const PcfSettings *settings, const BiasSettings *bias)
{
    bool grid =
        !uses_disc(settings) && !settings->bilinear && !settings->adaptive;
    Lookups lookups = bias_lookups(bias, settings->kernel / 2 + 1,
                                   grid ? settings->kernel : 0, GL_R32F);
    lookups.compares = true;
    return lookups;
}

const char *pcf_constants(PcfSettings *settings)
{
    snprintf(settings->constants, sizeof settings->constants,
             "const int kernel = %d;", settings->kernel);
    return settings->constants;
}
