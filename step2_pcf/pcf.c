#include "step2_pcf/pcf.h"

#include <stdio.h> // snprintf

const Option pcf_options[] = {
    {"kernel", OPTION_ODD, offsetof(PcfSettings, kernel), 1, 255, NULL, "N",
     "filter width in texels of the map, N x N comparisons"},
    {0},
};

PcfSettings pcf_settings(void)
{
    return (PcfSettings){.kernel = 7};
}

Lookups pcf_lookups(const PcfSettings *settings, const BiasSettings *bias)
{
    Lookups lookups =
        bias_lookups(bias, settings->kernel / 2 + 1, settings->kernel);
    lookups.compares = true;
    return lookups;
}

const char *const pcf_shaders[] = {"step1_shadowmap/shaders/depth_slope.glsl",
                                   "step1_shadowmap/shaders/bias.glsl",
                                   "step2_pcf/shaders/map_depth.glsl",
                                   "step2_pcf/shaders/pcf.glsl", NULL};

void pcf_constants(const PcfSettings *settings, char text[PCF_CONSTANTS_BYTES])
{
    snprintf(text, PCF_CONSTANTS_BYTES, "const int kernel = %d;",
             settings->kernel);
}
