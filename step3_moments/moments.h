// Step 3: two moments of the depth in place of the depth.
#ifndef STEP3_MOMENTS_H
#define STEP3_MOMENTS_H

#include <stdbool.h>

#include "step1_shadowmap/shadow_map.h" // shadow_map_draw_layer

typedef struct MomentsSettings {
    const char *format;     // rg32f or rg16f
    const char *moments;    // raw or central
    const char *depth;      // linear or projected
    bool slope_term;        // the depth's slope across a texel goes into M2
    const char *slope_from; // plane or derivatives
    int msaa;               // samples per texel while the map is drawn
} MomentsSettings;

extern const Option moments_options[];

// --show mean and --show variance.
extern const ShowMode moments_shows[];

MomentsSettings moments_settings(void);

// Refuses (status 2) options that contradict each other. Tells base the formula
// of t.
void moments_settings_check(const MomentsSettings *settings, BaseSettings *base,
                            const OptionTable tables[]);

// Whether t is z / w of the view, for a light that has one.
bool moments_projected(const MomentsSettings *settings);

// The shader file with the formula of the depth t, for the map and the picture.
const char *moments_depth_shader(const MomentsSettings *settings);

// Whether texels hold mean and variance, and not M1 and M2.
bool moments_are_central(const MomentsSettings *settings);

// The shader files that know what a texel holds: how moments are averaged
// (struct Merge, far_moments, moments_of, variance_of), what a texel keeps of
// them (stored) and what is between texels (moments_between). The last two
// come after the first.
const char *moments_merge_shader(const MomentsSettings *settings);
const char *moments_store_shader(const MomentsSettings *settings);
const char *moments_between_shader(const MomentsSettings *settings);

// The OpenGL format that the moments are stored in.
GLenum moments_format(const MomentsSettings *settings);

// A shadow map of two channels, M1 = t and M2 = t^2 or (central) t and 0, and
// with the slope term the variance of t across the texel added to the second.
// It is looked up bilinearly: unlike depths, moments may be averaged.
typedef struct Moments {
    const MomentsSettings *settings;
    Target target;
    Program *program;
    Target samples; // with --msaa: what the texels are averages of
    Program *resolve;
} Moments;

// `looked_up`: how many texels the picture itself reads to each side, or 0.
// Keeps the pointer to the settings.
void moments_create(Moments *moments, Frame *frame,
                    const MomentsSettings *settings, int looked_up);

void moments_draw(Moments *moments, const Frame *frame);

// How a filtered map is looked up, between its texels and outside.
Sampling moments_sampling(const MomentsSettings *settings);

#endif
