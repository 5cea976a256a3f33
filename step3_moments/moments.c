#include "step3_moments/moments.h"

#include <string.h> // strcmp

const Option moments_options[] = {
    {.name = "format",
     .kind = OPTION_CHOICE,
     .offset = offsetof(MomentsSettings, format),
     .choices = "rg32f,rg16f",
     .help = "what the two moments are stored in: 32 or 16 bit floats"},
    {.name = "depth",
     .kind = OPTION_CHOICE,
     .offset = offsetof(MomentsSettings, depth),
     .choices = "linear,projected",
     .help = "the depth of a spot or point light: its distance, or z / w of "
             "the view; the same for a directional light"},
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
    return (MomentsSettings){.format = "rg32f", .depth = "linear"};
}

const char *moments_depth_shader(const MomentsSettings *settings)
{
    return strcmp(settings->depth, "projected") == 0
               ? "step3_moments/shaders/projected_depth.glsl"
               : "step1_shadowmap/shaders/linear_depth.glsl";
}

GLenum moments_format(const MomentsSettings *settings)
{
    return strcmp(settings->format, "rg16f") == 0 ? GL_RG16F : GL_RG32F;
}

ShadowMap moments_create(ShaderFiles files, const Views *views,
                         const MomentsSettings *settings)
{
    const char *const fill[] = {moments_depth_shader(settings),
                                "step3_moments/shaders/moments.frag", NULL};
    return shadow_map_create(shadow_map_program(files, fill), views,
                             moments_format(settings), GL_LINEAR);
}
