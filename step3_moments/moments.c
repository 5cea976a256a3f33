#include "step3_moments/moments.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/die.h" // die_usage

const Option moments_options[] = {
    {.name = "format",
     .kind = OPTION_CHOICE,
     .offset = offsetof(MomentsSettings, format),
     .choices = "rg32f,rg16f",
     .help = "what the two moments are stored in: 32 or 16 bit floats"},
    {.name = "moments",
     .kind = OPTION_CHOICE,
     .offset = offsetof(MomentsSettings, moments),
     .choices = "raw,central",
     .help = "what a texel holds: E[x] and E[x^2] of its depths x, or their "
             "mean and variance"},
    {.name = "depth",
     .kind = OPTION_CHOICE,
     .offset = offsetof(MomentsSettings, depth),
     .choices = "linear,projected",
     .help = "the depth of a spot or point light: its distance, or z / w of "
             "the view; the same for a directional light"},
    {.name = "slope-term",
     .kind = OPTION_FLAG,
     .offset = offsetof(MomentsSettings, slope_term),
     .help = "add to the second moment what the depth's slope across a texel "
             "makes of it"},
    {.name = "slope-from",
     .kind = OPTION_CHOICE,
     .offset = offsetof(MomentsSettings, slope_from),
     .choices = "plane,derivatives",
     .help = "with --slope-term: the triangle's plane, or the depth of the "
             "next fragments"},
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
    return (MomentsSettings){.format = "rg32f",
                             .moments = "raw",
                             .depth = "linear",
                             .slope_from = "plane"};
}

void moments_settings_check(const MomentsSettings *settings,
                            const OptionTable tables[])
{
    if (options_given(tables, "slope-from") && !settings->slope_term) {
        die_usage("--slope-from %s needs --slope-term: add --slope-term or "
                  "drop --slope-from",
                  settings->slope_from);
    }
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

bool moments_are_central(const MomentsSettings *settings)
{
    return strcmp(settings->moments, "central") == 0;
}

const char *moments_merge_shader(const MomentsSettings *settings)
{
    return moments_are_central(settings)
               ? "step3_moments/shaders/merge_central.glsl"
               : "step3_moments/shaders/merge_raw.glsl";
}

const char *moments_store_shader(const MomentsSettings *settings)
{
    return moments_are_central(settings) && moments_format(settings) == GL_RG16F
               ? "step3_moments/shaders/store_half.glsl"
               : "step3_moments/shaders/store_float.glsl";
}

const char *moments_between_shader(const MomentsSettings *settings)
{
    return moments_are_central(settings)
               ? "step3_moments/shaders/between_central.glsl"
               : "step3_moments/shaders/between_raw.glsl";
}

static Program raw_program(ShaderFiles files, const MomentsSettings *settings)
{
    const char *const fill[] = {moments_depth_shader(settings),
                                "step3_moments/shaders/moments.frag", NULL};
    return shadow_map_program(files, fill);
}

static Program central_program(ShaderFiles files,
                               const MomentsSettings *settings)
{
    const char *const fill[] = {
        moments_depth_shader(settings), moments_merge_shader(settings),
        moments_store_shader(settings),
        "step3_moments/shaders/moments_central.frag", NULL};
    return shadow_map_program(files, fill);
}

static Program derivatives_program(ShaderFiles files,
                                   const MomentsSettings *settings)
{
    const char *const fill[] = {moments_depth_shader(settings),
                                "step3_moments/shaders/slope_derivatives.glsl",
                                moments_merge_shader(settings),
                                moments_store_shader(settings),
                                "step3_moments/shaders/moments_slope.frag",
                                NULL};
    return shadow_map_program(files, fill);
}

// Only a geometry shader sees a whole triangle.
static Program plane_program(ShaderFiles files, const MomentsSettings *settings)
{
    const char *const vertex[] = {"step1_shadowmap/shaders/map.vert", NULL};
    const char *const geometry[] = {"step3_moments/shaders/triangle_plane.geom",
                                    NULL};
    const char *const fragment[] = {"step1_shadowmap/shaders/light_depth.glsl",
                                    moments_depth_shader(settings),
                                    "step1_shadowmap/shaders/depth_slope.glsl",
                                    "step3_moments/shaders/slope_plane.glsl",
                                    moments_merge_shader(settings),
                                    moments_store_shader(settings),
                                    "step3_moments/shaders/moments_slope.frag",
                                    NULL};
    return gl_program_of_triangles(files, vertex, geometry, fragment);
}

static Program create_program(ShaderFiles files,
                              const MomentsSettings *settings)
{
    if (!settings->slope_term) {
        return moments_are_central(settings) ? central_program(files, settings)
                                             : raw_program(files, settings);
    }
    return strcmp(settings->slope_from, "plane") == 0
               ? plane_program(files, settings)
               : derivatives_program(files, settings);
}

ShadowMap moments_create(ShaderFiles files, const Views *views,
                         const MomentsSettings *settings)
{
    ShadowMap map = shadow_map_create(create_program(files, settings), views,
                                      moments_format(settings), GL_LINEAR);
    if (moments_are_central(settings)) {
        map.far[1] = 0; // far depth does not vary
    }
    return map;
}
