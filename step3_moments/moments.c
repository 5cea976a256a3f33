#include "step3_moments/moments.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h" // die_usage
#include "step3_moments/multisample.h"       // multisample_draw_layer

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
             "mean and variance; step 5 takes central ones by itself with "
             "--format rg16f, --mips and --soft"},
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
                              : "step3_moments/shaders/centre_out.glsl";
}

static const char *place_in(const MomentsSettings *settings)
{
    return settings->msaa > 1 ? "step3_moments/shaders/centroid_in.glsl"
                              : "step3_moments/shaders/centre_in.glsl";
}

static Program *map_program(Shaders *shaders, const MomentsSettings *settings,
                            const char *const fragment[])
{
    static const char *const centre[] = {"step1_shadowmap/shaders/map.vert",
                                         NULL};
    static const char *const centroid[] = {
        "step3_moments/shaders/centroid_out.glsl",
        "step3_moments/shaders/map_handing.vert", NULL};
    return gl_program(shaders, NULL, settings->msaa > 1 ? centroid : centre,
                      fragment);
}

static Program *raw_program(Shaders *shaders, const MomentsSettings *settings)
{
    const char *const fragment[] = {"step1_shadowmap/shaders/light_depth.glsl",
                                    moments_depth_shader(settings),
                                    place_in(settings),
                                    "step3_moments/shaders/moments.frag", NULL};
    return map_program(shaders, settings, fragment);
}

static Program *central_program(Shaders *shaders,
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
    return map_program(shaders, settings, fragment);
}

static Program *derivatives_program(Shaders *shaders,
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
    return map_program(shaders, settings, fragment);
}

// Only a geometry shader sees a whole triangle.
static Program *plane_program(Shaders *shaders, const MomentsSettings *settings)
{
    const char *const vertex[] = {"step3_moments/shaders/corner_out.glsl",
                                  "step3_moments/shaders/map_handing.vert",
                                  NULL};
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
    return gl_program_of_triangles(shaders, NULL, vertex, geometry, fragment);
}

static Program *create_program(Shaders *shaders,
                               const MomentsSettings *settings)
{
    if (!settings->slope_term) {
        return moments_are_central(settings)
                   ? central_program(shaders, settings)
                   : raw_program(shaders, settings);
    }
    return strcmp(settings->slope_from, "plane") == 0
               ? plane_program(shaders, settings)
               : derivatives_program(shaders, settings);
}

// Raw moments may be averaged by the texture unit. Far depth does not vary.
Sampling moments_sampling(const MomentsSettings *settings)
{
    return moments_are_central(settings) ? (Sampling){GL_NEAREST, {1, 0, 1, 1}}
                                         : (Sampling){GL_LINEAR, {1, 1, 1, 1}};
}

void moments_create(Moments *moments, Frame *frame,
                    const MomentsSettings *settings, int looked_up)
{
    moments->settings = settings;
    moments->program = create_program(&frame->shaders, settings);
    moments->target = frame_map(frame, "moments", moments_format(settings),
                                moments_sampling(settings));
    moments->target.file = "moments";
    moments->target.depth = settings->msaa == 1;
    moments->target.looked_up = looked_up;
    if (settings->msaa > 1) {
        multisample_create(moments, frame);
    }
    target_add(&frame->targets, &moments->target);
}

void moments_draw(Moments *moments, const Frame *frame)
{
    for (int layer = 0; layer < moments->target.layers; layer++) {
        if (moments->settings->msaa > 1) {
            multisample_draw_layer(moments, frame, layer);
        } else {
            shadow_map_draw_layer(&moments->target, moments->program, frame,
                                  layer);
        }
    }
    if (moments->settings->msaa > 1 && frame->dump != NULL) {
        multisample_dump_positions(moments, frame->dump);
    }
}
