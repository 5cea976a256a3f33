// Step 2: percentage-closer filtering.
#ifndef STEP2_PCF_H
#define STEP2_PCF_H

#include <glad/gl.h> // GLuint

#include "step1_shadowmap/base/options.h" // Option

typedef struct PcfSettings {
    int kernel;          // n of n x n taps, odd
    bool bilinear;       // each tap is a weighted mean of 2 x 2 comparisons
    const char *pattern; // where the taps are: grid or poisson
} PcfSettings;

extern const Option pcf_options[];

PcfSettings pcf_settings(void);

// Exits with 2 and one line where two options contradict each other.
void pcf_settings_check(const PcfSettings *settings);

enum { PCF_MAX_FILES = 4 };

// The shader files that define visibility() for these settings, NULL at the
// end.
void pcf_shaders(const PcfSettings *settings, const char *files[PCF_MAX_FILES]);

// How many texels the filter reads to each side of the receiver's own.
int pcf_reach(const PcfSettings *settings);

// Sets the uniform of pcf.glsl.
void pcf_apply(const PcfSettings *settings, GLuint program);

#endif
