#include "step3_moments/moments.h"

#include <string.h> // strcmp

const Option moments_options[] = {
    {.name = "format",
     .kind = OPTION_CHOICE,
     .offset = offsetof(MomentsSettings, format),
     .choices = "rg32f,rg16f",
     .help = "what the two moments are stored in: 32 or 16 bit floats"},
    {0},
};

const ShowMode moments_shows[] = {
    {"mean", "step3_moments/shaders/show_mean.glsl",
     "step1_shadowmap/shaders/scale_grey.glsl",
     "0 near     mean depth in the map    1 far"},
    {"variance", "step3_moments/shaders/show_variance.glsl",
     "step3_moments/shaders/scale_fire.glsl",
     "1e-9      variance  log scale        1e-1"},
    {NULL, NULL, NULL, NULL},
};

MomentsSettings moments_settings(void)
{
    return (MomentsSettings){.format = "rg32f"};
}

GLenum moments_format(const MomentsSettings *settings)
{
    return strcmp(settings->format, "rg16f") == 0 ? GL_RG16F : GL_RG32F;
}

ShadowMap moments_create(ShaderFiles files, const Views *views,
                         const MomentsSettings *settings)
{
    return shadow_map_create(files, views, moments_format(settings), GL_LINEAR,
                             "step3_moments/shaders/moments.frag");
}
