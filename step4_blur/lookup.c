// How the picture looks the filtered map up.
#include "step4_blur/blur.h"

#include "step1_shadowmap/base/picture/picture.h" // picture_footprint

const char blur_sat_lookup[] = "step4_blur/shaders/lookup_sat.glsl";

static const char *const bilinear[] = {
    "step3_moments/shaders/lookup_bilinear.glsl", NULL};
static const char *const trilinear[] = {
    picture_footprint, "step1_shadowmap/shaders/ellipse.glsl",
    "step4_blur/shaders/mip_levels.glsl",
    "step4_blur/shaders/lookup_trilinear.glsl", NULL};
static const char *const anisotropic[] = {
    picture_footprint, "step1_shadowmap/shaders/ellipse.glsl",
    "step4_blur/shaders/mip_levels.glsl",
    "step4_blur/shaders/lookup_anisotropic.glsl", NULL};
static const char *const hardware[] = {
    picture_footprint, "step4_blur/shaders/lookup_hardware.glsl", NULL};
static const char *const box[] = {"step4_blur/shaders/sat_box.glsl",
                                  blur_sat_lookup, NULL};

static const char *const *lookup(const BlurSettings *settings)
{
    if (blur_uses_hardware(settings)) {
        return hardware;
    }
    if (settings->mips) {
        return settings->anisotropy > 1 ? anisotropic : trilinear;
    }
    return settings->sat ? box : bilinear;
}

void blur_picture_shaders(const BlurSettings *settings,
                          const MomentsSettings *moments,
                          const char *visibility, const char *files[])
{
    const char *const *from = lookup(settings);
    *files++ = moments_merge_shader(moments);
    if (!settings->sat && !blur_uses_hardware(settings)) {
        *files++ = moments_between_shader(moments);
    }
    while (*from != NULL) {
        *files++ = *from++;
    }
    *files++ = visibility;
    *files = NULL;
}

// How many texels of the finest level a lookup may read beyond the 90 degrees
// of a point light's face. Nothing was drawn beyond its border: the seams would
// show. No other light's map ends where receivers are: of splits the next one
// has taken over before.
static double free_texels(const Views *views, int factor, int radius)
{
    bool point = views->light_position[3] != 0 && views->layers > 1;
    return point ? views->border / factor - radius : 1e9;
}

// The coarsest level that stays within these texels. In texels of the finest,
// one of level k holds 1.5 (2^k - 1) to both sides of its centre, for 1 3 3 1
// adds 1.5 of each level's own, and a bilinear lookup adds 2^k.
static int last_level(int levels, double free)
{
    int last = levels - 1;
    while (last > 0 && 2.5 * (1 << last) - 1.5 > free) {
        last--;
    }
    return last;
}

int blur_last_level(const BlurSettings *settings, const Views *views,
                    int levels)
{
    return last_level(levels, free_texels(views, settings->downsample,
                                          blur_used_radius(settings)));
}

static void set_levels(const Blur *blur, const Frame *frame, GLuint program)
{
    const BlurSettings *settings = blur->settings;
    int radius = settings->sat ? 0 : blur_used_radius(settings);
    double free = free_texels(&frame->views, settings->downsample, radius);
    int last = last_level(blur->mips.levels, free);
    if (blur_uses_hardware(settings)) {
        mips_limit_sampler(&blur->mips, last);
    }
    glUniform1i(glGetUniformLocation(program, "last_level"), last);
    glUniform1i(glGetUniformLocation(program, "anisotropy"),
                settings->anisotropy);
    glUniform1f(glGetUniformLocation(program, "free_texels"), (float)free);
}

void blur_set_lookup(const Blur *blur, const Frame *frame, GLuint program)
{
    if (blur->mips.levels > 0 && frame->looks_up) {
        set_levels(blur, frame, program);
    }
    if (blur->settings->sat) {
        sat_set_lookup(&blur->sat, program);
    }
}
