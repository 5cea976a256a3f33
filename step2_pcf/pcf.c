#include "step2_pcf/pcf.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/die.h" // die_usage

const Option pcf_options[] = {
    {.name = "kernel",
     .kind = OPTION_ODD,
     .offset = offsetof(PcfSettings, kernel),
     .minimum = 1,
     .maximum = 255,
     .argument = "N",
     .help = "filter width in texels of the map, N x N comparisons"},
    {.name = "bilinear",
     .kind = OPTION_FLAG,
     .offset = offsetof(PcfSettings, bilinear),
     .help = "each comparison a weighted mean of 2 x 2, without steps"},
    {.name = "pattern",
     .kind = OPTION_CHOICE,
     .offset = offsetof(PcfSettings, pattern),
     .choices = "grid,poisson",
     .help = "where the comparisons are: in every texel of a square, or 32 in "
             "a disc, turned in every pixel"},
    {0},
};

PcfSettings pcf_settings(void)
{
    return (PcfSettings){.kernel = 7, .pattern = "grid"};
}

static bool is_poisson(const PcfSettings *settings)
{
    return strcmp(settings->pattern, "poisson") == 0;
}

void pcf_settings_check(const PcfSettings *settings)
{
    if (settings->bilinear && is_poisson(settings)) {
        die_usage("--bilinear weights a grid's rim, which --pattern poisson "
                  "has not: drop one of them");
    }
}

void pcf_shaders(const PcfSettings *settings, const char *files[PCF_MAX_FILES])
{
    *files++ = "step2_pcf/shaders/map_depth.glsl";
    if (is_poisson(settings)) {
        *files++ = "step2_pcf/shaders/poisson_disc.glsl";
        *files++ = "step2_pcf/shaders/pcf_poisson.glsl";
    } else {
        *files++ = settings->bilinear ? "step2_pcf/shaders/pcf_bilinear.glsl"
                                      : "step2_pcf/shaders/pcf.glsl";
    }
    *files = NULL;
}

int pcf_reach(const PcfSettings *settings)
{
    return settings->kernel / 2 + 1;
}

void pcf_apply(const PcfSettings *settings, GLuint program)
{
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "kernel"), settings->kernel);
}
