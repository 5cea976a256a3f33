// Step 5, --sat-width: how wide a summed-area table's box is at each pixel.
#ifndef STEP5_SAT_WIDTH_H
#define STEP5_SAT_WIDTH_H

#include "step4_blur/blur.h" // BLUR_MAX_SHADERS

typedef struct SatWidthSettings {
    const char *width; // fixed or adaptive
} SatWidthSettings;

extern const Option sat_width_options[];

SatWidthSettings sat_width_settings(void);

// Refuses (status 2) a width without a table.
void sat_width_check(const BlurSettings *blur, const OptionTable tables[]);

// A list of shader files with the fixed box's lookup.
enum { SAT_WIDTH_MAX_SHADERS = BLUR_MAX_SHADERS + 2 };

// Where the width is adaptive, puts its lookup and the footprint that this one
// asks for in place of the fixed box's, in a list that has room for one more.
void sat_width_shaders(const SatWidthSettings *settings,
                       const char *files[SAT_WIDTH_MAX_SHADERS]);

#endif
