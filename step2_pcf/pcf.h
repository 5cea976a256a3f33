// Step 2: percentage-closer filtering.
#ifndef STEP2_PCF_H
#define STEP2_PCF_H

#include <glad/gl.h> // GLuint

#include "step1_shadowmap/base/options.h" // Option

typedef struct PcfSettings {
    int kernel;    // n of n x n taps, odd
    bool bilinear; // each tap is a weighted mean of 2 x 2 comparisons
} PcfSettings;

extern const Option pcf_options[];

PcfSettings pcf_settings(void);

// The shader file that defines visibility() for these settings.
const char *pcf_shader(const PcfSettings *settings);

// How many texels the filter reads to each side of the receiver's own.
int pcf_reach(const PcfSettings *settings);

// Sets the uniform of pcf.glsl.
void pcf_apply(const PcfSettings *settings, GLuint program);

#endif
