#include "step3_moments/moments.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h"   // die_usage
#include "step1_shadowmap/base/picture/dump.h" // dump_layers

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
    {.name = "msaa",
     .kind = OPTION_INTEGER,
     .offset = offsetof(MomentsSettings, msaa),
     .minimum = 1,
     .maximum = 64,
     .argument = "N",
     .help = "samples per texel while the map is drawn, of which it keeps the "
             "moments"},
    {0},
};

const ShowMode moments_shows[] = {
    {"mean", "step3_moments/shaders/show_mean.glsl",
     "step1_shadowmap/shaders/scale_grey.glsl",
     "0 near     mean depth in the map    1 far", true},
    {"variance", "step3_moments/shaders/show_variance.glsl",
     "step3_moments/shaders/scale_fire.glsl",
     "1e-9      variance  log scale        1e-1", true},
    {NULL, NULL, NULL, NULL, false},
};

MomentsSettings moments_settings(void)
{
    return (MomentsSettings){.format = "rg32f",
                             .moments = "raw",
                             .depth = "linear",
                             .slope_from = "plane",
                             .msaa = 1};
}

void moments_settings_check(const MomentsSettings *settings, BaseSettings *base,
                            const OptionTable tables[])
{
    if (options_given(tables, "slope-from") && !settings->slope_term) {
        die_usage("--slope-from %s needs --slope-term: add --slope-term or "
                  "drop --slope-from",
                  settings->slope_from);
    }
    if (settings->msaa > 1 && strcmp(settings->slope_from, "plane") != 0) {
        die_usage("--slope-from %s: with --msaa %d the next fragment is not "
                  "one texel away: drop one",
                  settings->slope_from, settings->msaa);
    }
    base->depth_shader = moments_depth_shader(settings);
}

bool moments_projected(const MomentsSettings *settings)
{
    return strcmp(settings->depth, "projected") == 0;
}

const char *moments_depth_shader(const MomentsSettings *settings)
{
    return moments_projected(settings)
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

// Where in its texel a fragment has its position: in the middle, or with --msaa
// at a place that its triangle covers. The files that hand it to the fragments,
// and in which these get it.
static const char *place_out(const MomentsSettings *settings)
{
    return settings->msaa > 1 ? "step3_moments/shaders/centroid_out.glsl"
                              : "step1_shadowmap/shaders/centre_out.glsl";
}

static const char *place_in(const MomentsSettings *settings)
{
    return settings->msaa > 1 ? "step3_moments/shaders/centroid_in.glsl"
                              : "step3_moments/shaders/centre_in.glsl";
}

static Program map_program(ShaderFiles files, const MomentsSettings *settings,
                           const char *const fragment[])
{
    const char *const vertex[] = {place_out(settings),
                                  "step1_shadowmap/shaders/map.vert", NULL};
    return gl_program(files, vertex, fragment);
}

static Program raw_program(ShaderFiles files, const MomentsSettings *settings)
{
    const char *const fragment[] = {"step1_shadowmap/shaders/light_depth.glsl",
                                    moments_depth_shader(settings),
                                    place_in(settings),
                                    "step3_moments/shaders/moments.frag", NULL};
    return map_program(files, settings, fragment);
}

static Program central_program(ShaderFiles files,
                               const MomentsSettings *settings)
{
    const char *const fragment[] = {
        "step1_shadowmap/shaders/light_depth.glsl",
        moments_depth_shader(settings),
        place_in(settings),
        moments_merge_shader(settings),
        moments_store_shader(settings),
        "step3_moments/shaders/moments_central.frag",
        NULL};
    return map_program(files, settings, fragment);
}

static Program derivatives_program(ShaderFiles files,
                                   const MomentsSettings *settings)
{
    const char *const fragment[] = {
        "step1_shadowmap/shaders/light_depth.glsl",
        moments_depth_shader(settings),
        place_in(settings),
        "step3_moments/shaders/slope_derivatives.glsl",
        moments_merge_shader(settings),
        moments_store_shader(settings),
        "step3_moments/shaders/moments_slope.frag",
        NULL};
    return map_program(files, settings, fragment);
}

// Only a geometry shader sees a whole triangle.
static Program plane_program(ShaderFiles files, const MomentsSettings *settings)
{
    const char *const vertex[] = {"step3_moments/shaders/corner_out.glsl",
                                  "step1_shadowmap/shaders/map.vert", NULL};
    const char *const geometry[] = {
        place_out(settings), "step3_moments/shaders/triangle_plane.geom", NULL};
    const char *const fragment[] = {"step1_shadowmap/shaders/light_depth.glsl",
                                    moments_depth_shader(settings),
                                    place_in(settings),
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

static Program resolve_program(ShaderFiles files,
                               const MomentsSettings *settings)
{
    const char *const vertex[] = {"step1_shadowmap/shaders/fullscreen.vert",
                                  NULL};
    const char *const fragment[] = {moments_merge_shader(settings),
                                    moments_store_shader(settings),
                                    "step3_moments/shaders/resolve.frag", NULL};
    return gl_program(files, vertex, fragment);
}

// Raw moments may be averaged by the texture unit. Far depth does not vary.
static Sampling moments_sampling(const MomentsSettings *settings)
{
    return moments_are_central(settings) ? (Sampling){GL_NEAREST, {1, 0, 1, 1}}
                                         : (Sampling){GL_LINEAR, {1, 1, 1, 1}};
}

MomentsMap moments_create(ShaderFiles files, const Views *views,
                          const MomentsSettings *settings)
{
    GLenum format = moments_format(settings);
    MomentsMap map = {
        .settings = settings,
        .texels = shadow_map_create(create_program(files, settings), views,
                                    format, moments_sampling(settings))};
    if (settings->msaa > 1) {
        map.samples =
            multisample_create(resolve_program(files, settings), settings->msaa,
                               format, views->width, views->height);
    }
    map.bytes = map.texels.bytes + map.samples.bytes;
    return map;
}

void moments_draw(MomentsMap *map, const Geometry *geometry,
                  const MapPlan *plan)
{
    if (map->samples.samples > 0) {
        map->touched =
            multisample_draw(&map->samples, &map->texels, geometry, plan);
    } else {
        shadow_map_draw(&map->texels, geometry, plan);
        map->touched = map->texels.touched;
    }
}

void moments_dump(MomentsMap *map, const Geometry *geometry,
                  const MapPlan *plan, const char *directory)
{
    const ShadowMap *texels = &map->texels;
    MapPlan whole = map_plan_whole(plan);
    moments_draw(map, geometry, &whole);
    dump_layers(directory, "moments", texels->texture, texels->width,
                texels->height, texels->layers, texels->channels);
    if (map->samples.samples > 0) {
        multisample_dump(&map->samples, texels, geometry, &whole, directory);
    }
}

bool moments_reload(MomentsMap *map, MapPlan *plan)
{
    return shadow_map_reload(&map->texels, plan) &&
           multisample_reload(&map->samples);
}

void moments_destroy(MomentsMap *map)
{
    multisample_destroy(&map->samples);
    shadow_map_destroy(&map->texels);
}
