#include <stdio.h>  // snprintf
#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h"        // die_usage
#include "step3_moments/techniques/shared/shared.h" // moments_merged

static struct Settings {
    bool term;        // the depth's slope across a texel goes into M2
    const char *from; // plane or derivatives
} settings = {.from = "plane"};

static const Option options[] = {
    {.name = "slope-term",
     .kind = OPTION_FLAG,
     .offset = offsetof(struct Settings, term),
     .help = "add to the second moment what the depth's slope across a texel "
             "makes of it"},
    {.name = "slope-from",
     .kind = OPTION_CHOICE,
     .offset = offsetof(struct Settings, from),
     .choices = "plane,derivatives",
     .help = "with --slope-term: the triangle's plane, or the depth of the "
             "next fragments"},
    {0},
};

static void check(Frame *frame)
{
    const int *msaa = options_value(frame->options, "msaa");
    if (options_given(frame->options, "slope-from") && !settings.term) {
        die_usage("--slope-from %s needs --slope-term: add --slope-term or "
                  "drop --slope-from",
                  settings.from);
    }
    if (*msaa > 1 && strcmp(settings.from, "plane") != 0) {
        die_usage("--slope-from %s: with --msaa %d the next fragment is not "
                  "one texel away: drop one",
                  settings.from, *msaa);
    }
}

// Only a geometry shader sees a whole triangle.
static void put_plane(Frame *frame)
{
    static const char *const corners[] = {
        "step3_moments/techniques/slope/corner_out.glsl",
        "step3_moments/techniques/shared/map_handing.vert",
        "step3_moments/techniques/shared/centre_out.glsl",
        "step3_moments/techniques/slope/triangle_plane.geom", NULL};
    static const char *const slope[] = {
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step3_moments/techniques/slope/slope_plane.glsl",
        "step3_moments/techniques/slope/slope_inside.glsl", NULL};
    const int *size = frame->settings.map_size;
    char text[80];
    snprintf(text, sizeof text, "const vec2 slope_map_size = vec2(%d, %d);",
             size[0], size[1]);
    gl_put_in_front(&frame->shaders, text);
    gl_put_instead(&frame->shaders, "step1_shadowmap/shaders/map.vert",
                   corners);
    gl_put_instead(&frame->shaders, "step3_moments/techniques/shared/flat.glsl",
                   slope);
}

static void put_derivatives(Frame *frame)
{
    static const char *const slope[] = {
        "step3_moments/techniques/slope/slope_derivatives.glsl",
        "step3_moments/techniques/slope/slope_inside.glsl", NULL};
    gl_put_instead(&frame->shaders, "step3_moments/techniques/shared/flat.glsl",
                   slope);
}

static bool prepare(Frame *frame)
{
    if (!settings.term) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step3_moments/shaders/moments.frag",
                   moments_merged);
    if (strcmp(settings.from, "plane") == 0) {
        put_plane(frame);
    } else {
        put_derivatives(frame);
    }
    return true;
}

const Technique moments_slope = {.options = options,
                                 .settings = &settings,
                                 .check = check,
                                 .prepare = prepare};
