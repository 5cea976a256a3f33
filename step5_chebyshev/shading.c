#include "step5_chebyshev/shading.h"

#include <string.h> // memmove, strcmp

#include "step1_shadowmap/base/system/die.h" // die_usage
#include "step1_shadowmap/shadow_map.h"      // bias_apply
#include "step5_chebyshev/deferred.h"        // deferred_source
#include "step5_chebyshev/guard_settings.h"  // guard_of_settings

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
    {.name = "soft",
     .kind = OPTION_FLAG,
     .offset = offsetof(ShadingSettings, soft),
     .help = "penumbrae grow with the way from what casts them, as those of a "
             "light with a size do"},
    {.name = "light-size",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ShadingSettings, softness.light_size),
     .minimum = 0,
     .maximum = 1e6,
     .argument = "X",
     .help = "with --soft: the light's diameter, in world units; of a "
             "directional one the tangent of the angle it is seen under"},
    {.name = "penumbra-scale",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ShadingSettings, softness.penumbra_scale),
     .minimum = 0,
     .maximum = 100,
     .argument = "X",
     .help = "with --soft: penumbrae are X times as wide, as far as occluders "
             "are searched for"},
    {.name = "hybrid",
     .kind = OPTION_FLAG,
     .offset = offsetof(ShadingSettings, hybrid),
     .help = "with --soft: compare depths in the penumbra, so that no light "
             "bleeds"},
    {0},
};

ShadingSettings shading_settings(void)
{
    return (ShadingSettings){
        .moments = moments_settings(),
        .blur = blur_settings(),
        .chebyshev = chebyshev_settings(),
        .sat_width = "fixed",
        .softness = {.light_size = 0.05, .penumbra_scale = 1}};
}

static void check_soft(const BlurSettings *blur, const int map_size[2],
                       const OptionTable tables[])
{
    for (int axis = 0; axis < 2; axis++) {
        if (map_size[axis] % blur->downsample == 0 &&
            map_size[axis] / blur->downsample % 2 != 0) {
            die_usage("--soft looks up mip-maps, and no map of %dx%d texels "
                      "can be halved: give an even --map-size or drop --soft",
                      map_size[0] / blur->downsample,
                      map_size[1] / blur->downsample);
        }
    }
    if (blur->sat) {
        die_usage("--soft looks up a mip-map chain, --sat makes a table: drop "
                  "one of them");
    }
    if (blur_uses_hardware(blur)) {
        die_usage("--soft chooses its levels itself: drop --soft or --sampler "
                  "%s",
                  blur->sampler);
    }
    if (options_given(tables, "blur-by") && !options_given(tables, "blur") &&
        !options_given(tables, "radius")) {
        die_usage("--soft blurs no map unless it is told to: add --blur box, "
                  "or drop --soft or --blur-by %s",
                  blur->by);
    }
    if (options_given(tables, "anisotropy")) {
        die_usage("--soft averages a disc, not the pixel's footprint: drop "
                  "--soft or --anisotropy %d",
                  blur->anisotropy);
    }
}

static void check_hybrid(const ShadingSettings *settings,
                         const OptionTable tables[])
{
    const char *filter = blur_used_radius(&settings->blur) > 0
                             ? "--blur and --radius"
                         : settings->blur.downsample > 1 ? "--downsample"
                         : settings->moments.msaa > 1    ? "--msaa"
                                                         : NULL;
    if (filter != NULL) {
        die_usage("--hybrid compares depths, and a filtered map has none: drop "
                  "--hybrid or %s",
                  filter);
    }
    if (options_given(tables, "bleed-reduction") ||
        options_given(tables, "reduction")) {
        die_usage("--hybrid lets no light bleed: drop --hybrid, or "
                  "--bleed-reduction and --reduction");
    }
}

static void check_needs_soft(const char *name, const OptionTable tables[])
{
    if (options_given(tables, name)) {
        die_usage("--%s needs --soft: add --soft or drop --%s", name, name);
    }
}

// In 16 bits raw moments have no variance left. In a mip-map chain they can
// lose so much (guard.h) that `auto` lights shadows near their casters. But a
// table sums raw moments, and the texture unit averages them.
static void choose_moments(ShadingSettings *settings)
{
    const BlurSettings *blur = &settings->blur;
    bool half = moments_format(&settings->moments) == GL_RG16F;
    if (blur->sat || blur_uses_hardware(blur)) {
        settings->why_moments = "only raw ones can be summed or averaged";
    } else if (half || blur->mips) {
        settings->moments.moments = "central";
        settings->why_moments = half ? "--format rg16f: raw ones need 32 bits"
                                     : "raw ones lose too much in mip-maps";
    } else {
        settings->why_moments = "raw ones lose little enough";
    }
}

void shading_check(ShadingSettings *settings, BaseSettings *base,
                   const OptionTable tables[])
{
    BlurSettings *blur = &settings->blur;
    moments_settings_check(&settings->moments, base, tables);
    if (settings->soft) {
        check_soft(blur, base->map_size, tables);
        blur->mips = true;
        if (!options_given(tables, "blur") &&
            !options_given(tables, "radius")) {
            blur->kernel = "none";
        }
    } else {
        check_needs_soft("light-size", tables);
        check_needs_soft("penumbra-scale", tables);
        check_needs_soft("hybrid", tables);
    }
    if (settings->hybrid) {
        check_hybrid(settings, tables);
    }
    settings->why_moments = "--moments";
    if (!options_given(tables, "moments")) {
        choose_moments(settings);
    }
    blur_check(blur, &settings->moments, base, tables);
    if (options_given(tables, "sat-width") && !blur->sat) {
        die_usage("--sat-width %s is of a summed-area table's box: add --sat "
                  "or drop --sat-width",
                  settings->sat_width);
    }
}

// Of 16 bits and samples it is not shown that a lone plane stays lit.
static bool keeps_planes_lit(const ShadingSettings *settings)
{
    return !settings->soft && settings->moments.msaa == 1 &&
           moments_format(&settings->moments) == GL_RG32F &&
           settings->chebyshev.min_variance == OPTION_AUTO;
}

Lookups shading_lookups(const ShadingSettings *settings, const Frame *frame)
{
    Lookups lookups = {
        .reach = settings->soft
                     ? soft_reach(&settings->softness, &settings->blur, frame)
                     : blur_reach(&settings->blur),
        .anywhere = settings->soft};
    if (keeps_planes_lit(settings)) {
        lookups.spread = blur_spread(&settings->blur);
    }
    return lookups;
}

// The shader file that says what variance and distance go into the bound.
static const char *guard_shader(const ShadingSettings *settings)
{
    if (settings->chebyshev.min_variance != OPTION_AUTO) {
        return "step5_chebyshev/shaders/guard_constant.glsl";
    }
    return moments_are_central(&settings->moments)
               ? "step5_chebyshev/shaders/guard_central.glsl"
               : "step5_chebyshev/shaders/guard_raw.glsl";
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
    files[place] = picture_footprint;
    files[place + 1] = "step5_chebyshev/shaders/lookup_sat_adaptive.glsl";
}

// Returns where the list goes on.
static const char **append(const char **files, const char *const more[])
{
    while (*more != NULL) {
        *files++ = *more++;
    }
    return files;
}

static const char **append_soft(const ShadingSettings *settings,
                                const char **files)
{
    const char *const soft[] = {
        moments_merge_shader(&settings->moments),
        moments_between_shader(&settings->moments),
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step4_blur/shaders/mip_levels.glsl",
        guard_shader(settings),
        "step5_chebyshev/shaders/chebyshev.glsl",
        "step2_pcf/techniques/poisson/poisson_disc.glsl",
        "step5_chebyshev/shaders/penumbra.glsl",
        "step5_chebyshev/shaders/lookup_soft.glsl",
        NULL};
    return append(files, soft);
}

// The blur's lookup, and the guard and the bound.
static const char **append_blur(const ShadingSettings *settings,
                                const char **files)
{
    static const char *const bound[] = {
        "step5_chebyshev/shaders/chebyshev.glsl", NULL};
    const char *usual[SHADING_MAX_SHADERS];
    blur_picture_shaders(&settings->blur, &settings->moments,
                         guard_shader(settings), usual);
    if (strcmp(settings->sat_width, "adaptive") == 0) {
        adapt_box(usual);
    }
    return append(append(files, usual), bound);
}

void shading_shaders(const ShadingSettings *settings, const char *files[])
{
    static const char *const compared[] = {
        "step1_shadowmap/shaders/bias.glsl",
        "step5_chebyshev/shaders/visibility_hybrid.glsl", NULL};
    const char *const bounded[] = {
        chebyshev_reduction_shader(&settings->chebyshev),
        "step5_chebyshev/shaders/visibility.glsl", NULL};
    files = settings->soft ? append_soft(settings, files)
                           : append_blur(settings, files);
    files = append(files, settings->hybrid ? compared : bounded);
    *files = NULL;
}

// Whether chebyshev_guard() knows every rounding. guard.c knows those of the
// techniques, too.
static bool is_plain(const MomentsSettings *moments, const BlurSettings *blur)
{
    return !moments_are_central(moments) && moments->msaa == 1 &&
           moments_format(moments) == GL_RG32F && !blur->mips && !blur->sat &&
           strcmp(blur->kernel, "boxes") != 0;
}

static void find_constants(ShadingSettings *settings, const Blur *filter)
{
    const BlurSettings *blur = &settings->blur;
    int lookups = settings->soft ? SOFT_TAPS : blur->anisotropy;
    GuardNumbers guard =
        is_plain(&settings->moments, blur)
            ? chebyshev_guard(blur_used_radius(blur), blur->downsample)
            : guard_of_settings(&settings->moments, blur, filter, lookups);
    chebyshev_constants(&settings->chebyshev, &guard, settings->constants);
}

void shading_picture(ShadingSettings *settings, Picture *picture, Frame *frame,
                     Blur *filter)
{
    const char *visibility[SHADING_MAX_SHADERS];
    shading_shaders(settings, visibility);
    find_constants(settings, filter);
    settings->told = (Target){.pass = "central moments",
                              .why = settings->why_moments,
                              .kind = TARGET_NOTHING,
                              .idle = !moments_are_central(&settings->moments)};
    target_add(&frame->targets, &settings->told);
    picture_create_from(picture, frame, deferred_source(settings->deferred),
                        &filter->result, settings->constants, visibility);
}

void shading_apply(const ShadingSettings *settings, const Views *views,
                   GLuint program)
{
    if (settings->soft) {
        soft_apply(&settings->softness, views,
                   moments_projected(&settings->moments), program);
    }
    if (settings->hybrid) {
        BiasSettings bias = bias_settings();
        bias_apply(&bias, program);
    }
}
