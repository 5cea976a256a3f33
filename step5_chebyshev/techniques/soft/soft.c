// --soft: penumbrae that grow with the way from what casts them; --hybrid:
// comparisons in them.
#include <math.h>   // cos, fmax, pow, sqrt
#include <stdio.h>  // snprintf
#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h"          // die_usage
#include "step1_shadowmap/shadow_map.h"               // bias_apply
#include "step5_chebyshev/techniques/guard/guarded.h" // guarded_visibility

// Of penumbra.glsl: texels of the filtered map.
enum { LEAST_DISC = 4 };

static struct Settings {
    bool soft;         // the penumbra is each receiver's own
    double light_size; // its diameter, world units; of a parallel light at a
                       // distance of 1: the tangent of its angle
    double penumbra_scale;
    bool hybrid; // comparisons in its penumbra, not moments
} settings = {.light_size = 0.05, .penumbra_scale = 1};

static const Option options[] = {
    {.name = "soft",
     .kind = OPTION_FLAG,
     .offset = offsetof(struct Settings, soft),
     .help = "penumbrae grow with the way from what casts them, as those of a "
             "light with a size do"},
    {.name = "light-size",
     .kind = OPTION_NUMBER,
     .offset = offsetof(struct Settings, light_size),
     .minimum = 0,
     .maximum = 1e6,
     .argument = "X",
     .help = "with --soft: the light's diameter, in world units; of a "
             "parallel one the tangent of the angle it is seen under"},
    {.name = "penumbra-scale",
     .kind = OPTION_NUMBER,
     .offset = offsetof(struct Settings, penumbra_scale),
     .minimum = 0,
     .maximum = 100,
     .argument = "X",
     .help = "with --soft: penumbrae are X times as wide, as far as occluders "
             "are searched for"},
    {.name = "hybrid",
     .kind = OPTION_FLAG,
     .offset = offsetof(struct Settings, hybrid),
     .help = "with --soft: compare depths in the penumbra, so that no light "
             "bleeds"},
    {0},
};

static void check_size(const Frame *frame)
{
    const int *size = frame->settings.map_size;
    int factor = options_integer(frame->options, "downsample");
    for (int axis = 0; axis < 2; axis++) {
        if (size[axis] % factor == 0 && size[axis] / factor % 2 != 0) {
            die_usage("--soft looks up mip-maps, and no map of %dx%d texels "
                      "can be halved: give an even --map-size or drop --soft",
                      size[0] / factor, size[1] / factor);
        }
    }
}

static void check_soft(const Frame *frame)
{
    const OptionTable *all = frame->options;
    check_size(frame);
    if (options_on(all, "sat")) {
        die_usage("--soft looks up a mip-map chain, --sat makes a table: drop "
                  "one of them");
    }
    if (options_is(all, "sampler", "hardware")) {
        die_usage("--soft chooses its levels itself: drop --soft or --sampler "
                  "hardware");
    }
    if (options_given(all, "blur-by") && !options_given(all, "blur") &&
        !options_given(all, "radius")) {
        const char *const *by = options_value(all, "blur-by");
        die_usage("--soft blurs no map unless it is told to: add --blur box, "
                  "or drop --soft or --blur-by %s",
                  *by);
    }
    if (options_given(all, "anisotropy")) {
        die_usage("--soft averages a disc, not the pixel's footprint: drop "
                  "--soft or --anisotropy %d",
                  options_integer(frame->options, "anisotropy"));
    }
}

static void check_hybrid(const Frame *frame)
{
    const OptionTable *all = frame->options;
    bool blurs = !options_is(all, "blur", "none") &&
                 options_integer(frame->options, "radius") > 0;
    const char *filter =
        blurs ? "--blur and --radius"
        : options_integer(frame->options, "downsample") > 1 ? "--downsample"
        : options_integer(frame->options, "msaa") > 1       ? "--msaa"
                                                            : NULL;
    if (filter != NULL) {
        die_usage("--hybrid compares depths, and a filtered map has none: drop "
                  "--hybrid or %s",
                  filter);
    }
    if (options_given(all, "bleed-reduction") ||
        options_given(all, "reduction")) {
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

// It looks up a chain of mip-maps, of moments that are not blurred unless a
// blur was asked for.
static void check(Frame *frame)
{
    if (!settings.soft) {
        check_needs_soft("light-size", frame->options);
        check_needs_soft("penumbra-scale", frame->options);
        check_needs_soft("hybrid", frame->options);
        return;
    }
    check_soft(frame);
    bool *mips = options_value(frame->options, "mips");
    const char **kernel = options_value(frame->options, "blur");
    *mips = true;
    if (!options_given(frame->options, "blur") &&
        !options_given(frame->options, "radius")) {
        *kernel = "none";
    }
    if (settings.hybrid) {
        check_hybrid(frame);
    }
}

// How many texels across the map one unit is, of a spot or point light at a
// distance of 1 along the view's axis. There the rows hold half of the axis.
static double texels_per_unit(const Views *views, const LightView *view)
{
    double squares = 0;
    for (int k = 0; k < 3; k++) {
        double across =
            view->map_from_relative[0][k] - 0.5 * view->map_from_relative[3][k];
        squares += across * across;
    }
    return sqrt(squares) * views->width;
}

// By how much a small circle grows in the map where it is furthest off the
// view's axis, at an angle c: to 1 / cos(c) along one direction, to
// 1 / cos^2(c) along the other. In the corner of a point light's view cos^2(c)
// is 1/3.
static double widest_spread(const Light *light)
{
    double cosine =
        light->kind == LIGHT_POINT ? sqrt(1 / 3.0) : cos(light->cone);
    return pow(cosine, -1.5);
}

// Texels of the full map across the widest search, that of a receiver at the
// far plane for occluders at the near plane.
static double widest_search(double light_size, const Views *views,
                            const Light *light)
{
    double widest = 0; // a lamp at the near plane itself: infinite
    for (int layer = 0; layer < views->layers; layer++) {
        const LightView *view = &views->light[layer];
        double width = light_size * (view->far - view->near);
        if (light->kind != LIGHT_DIRECTIONAL) {
            width *= widest_spread(light) / (view->near * view->far);
        }
        widest = fmax(widest, width * texels_per_unit(views, view));
    }
    return widest;
}

// How many texels of the full map the widest search reads to each side, with
// the blur before it: what views_fit is to leave room for. At most an eighth of
// the map, else most of it would hold what nobody sees. The least border's that
// is enough for the views which are fitted with it: the wider the border, the
// larger the texels, of which fewer are needed.
static int find_reach(const Frame *frame)
{
    const ViewsSize size = base_views_size(&frame->settings);
    int side = size.map[size.map[0] < size.map[1] ? 0 : 1];
    int blur = frame->lookups.reach;
    int low = LEAST_DISC * options_integer(frame->options, "downsample");
    int high = side / 8 > low ? side / 8 : low;
    while (low < high) {
        Views views;
        int middle = (low + high) / 2;
        views_fit(&views, &frame->scene, &size, blur + middle);
        if (widest_search(settings.light_size, &views, &frame->scene.light) <=
            middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return blur + high;
}

static void put_shaders(Frame *frame)
{
    static const char *const lookup[] = {
        "step3_moments/techniques/shared/merge_raw.glsl",
        "step3_moments/techniques/shared/between_raw.glsl",
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step4_blur/techniques/mips/mip_levels.glsl",
        "step5_chebyshev/techniques/guard/guard_raw.glsl",
        "step5_chebyshev/techniques/guard/bias_none.glsl",
        "step5_chebyshev/shaders/chebyshev.glsl",
        "step2_pcf/techniques/poisson/poisson_disc.glsl",
        "step5_chebyshev/techniques/soft/penumbra.glsl",
        "step5_chebyshev/techniques/soft/lookup_soft.glsl",
        NULL};
    static const char *const compared[] = {
        "step1_shadowmap/shaders/bias.glsl",
        "step5_chebyshev/techniques/soft/visibility_hybrid.glsl", NULL};
    gl_put_instead(&frame->shaders,
                   "step3_moments/shaders/lookup_bilinear.glsl", lookup);
    if (settings.hybrid) {
        gl_put_instead(&frame->shaders,
                       "step5_chebyshev/shaders/visibility.glsl", compared);
    }
}

static bool prepare(Frame *frame)
{
    if (!settings.soft) {
        return false;
    }
    put_shaders(frame);
    frame->lookups.reach = find_reach(frame);
    frame->lookups.anywhere = true;
    frame->lookups.spread = 0;
    return true;
}

// How a view's distance d follows from t: d = (x + y t) / (z + w t).
static void set_distance(const Views *views, int layer, bool projected,
                         GLuint program)
{
    char name[48];
    snprintf(name, sizeof name, "distance_of_depth[%d]", layer);
    GLint place = glGetUniformLocation(program, name);
    float near = (float)views->light[layer].near;
    float far = (float)views->light[layer].far;
    if (views->light_position[3] == 0) {
        glUniform4f(place, 0, far - near, 1, 0);
    } else if (projected) {
        glUniform4f(place, near * far, 0, far, near - far);
    } else {
        glUniform4f(place, near, far - near, 1, 0);
    }
}

static void look(const Frame *frame, GLuint program)
{
    bool projected = options_is(frame->options, "depth", "projected");
    glUniform1f(glGetUniformLocation(program, "light_size"),
                (float)settings.light_size);
    glUniform1f(glGetUniformLocation(program, "penumbra_scale"),
                (float)settings.penumbra_scale);
    for (int layer = 0; layer < frame->views.layers; layer++) {
        set_distance(&frame->views, layer, projected, program);
    }
    if (settings.hybrid) {
        BiasSettings bias = bias_settings();
        bias_apply(&bias, program);
    }
}

const Technique chebyshev_soft = {.options = options,
                                  .settings = &settings,
                                  .check = check,
                                  .prepare = prepare,
                                  .look = look};
