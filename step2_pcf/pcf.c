#include "step2_pcf/pcf.h"

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
    {0},
};

PcfSettings pcf_settings(void)
{
    return (PcfSettings){.kernel = 7};
}

const char *pcf_shader(const PcfSettings *settings)
{
    return settings->bilinear ? "step2_pcf/shaders/pcf_bilinear.glsl"
                              : "step2_pcf/shaders/pcf.glsl";
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
