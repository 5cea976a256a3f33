// Step 4: the moments, filtered before anyone looks them up.
#ifndef STEP4_BLUR_H
#define STEP4_BLUR_H

#include "step1_shadowmap/shadow_map.h" // BiasSettings

typedef struct BlurSettings {
    int radius;     // texels of the downsampled map
    int downsample; // factor along each axis
} BlurSettings;

extern const Option blur_options[];

BlurSettings blur_settings(void);

// Refuses (status 2) a radius that is wider than the map, and a factor that
// does not divide it.
void blur_check(const BlurSettings *settings, const BaseSettings *base);

// How many texels of the full map one filtered lookup reads to each side.
int blur_reach(const BlurSettings *settings);

// What blur.frag takes for constants: the radius, 2 radius + 1 weights that add
// up to 1, and the axis, 0 for u and 1 for v. A loop whose length is known when
// it is compiled takes half the time to draw (measured). The caller frees it.
char *blur_constants(int radius, const float weights[], int axis);

typedef struct Blur {
    Target small; // downsampled
    Program *downsample;
    Target passes[2]; // along u, then along v
    Program *programs[2];
    Target result; // what the picture looks up, filtered or not
} Blur;

// Filters a map of moments.
void blur_create(Blur *blur, Frame *frame, const BlurSettings *settings,
                 Target *moments);

void blur_apply(Blur *blur, const Frame *frame);

#endif
