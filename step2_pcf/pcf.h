// Step 2: percentage-closer filtering.
#ifndef STEP2_PCF_H
#define STEP2_PCF_H

#include "step1_shadowmap/base/system/options.h" // Option
#include "step1_shadowmap/shadow_map.h"          // BiasSettings

typedef struct PcfSettings {
    int kernel;          // n of n x n taps, odd
    const char *pattern; // grid or poisson
    bool bilinear;       // each tap is a weighted mean of 2 x 2 comparisons
    bool adaptive;       // n is the pixel's own, up to `kernel`
    char constants[32];  // of pcf_constants
} PcfSettings;

extern const Option pcf_options[];

PcfSettings pcf_settings(void);

// Refuses (status 2) options that contradict each other.
void pcf_settings_check(const PcfSettings *settings);

enum { PCF_MAX_SHADERS = 9 };

// The shader files that define visibility() for these settings, up to
// PCF_MAX_SHADERS with the NULL at the end.
void pcf_shaders(const PcfSettings *settings, const char *files[]);

// The picture's lookups: of a full grid of taps a kernel, for no other pattern
// is known to keep a lone plane lit.
Lookups pcf_lookups(const PcfSettings *settings, const BiasSettings *bias);

// What these files take for a constant: the kernel. A loop whose length is
// known when it is compiled takes half the time (measured). Valid as long as
// the settings.
const char *pcf_constants(PcfSettings *settings);

#endif
