// Step 2: percentage-closer filtering.
#ifndef STEP2_PCF_H
#define STEP2_PCF_H

#include "step1_shadowmap/base/system/options.h" // Option
#include "step1_shadowmap/shadow_map.h"          // BiasSettings

typedef struct PcfSettings {
    int kernel;         // n of n x n taps, odd
    char constants[32]; // of pcf_constants
} PcfSettings;

extern const Option pcf_options[];

PcfSettings pcf_settings(void);

// The picture's lookups, each of n x n texels.
Lookups pcf_lookups(const PcfSettings *settings, const BiasSettings *bias);

// The shader files that define visibility(); NULL at the end.
extern const char *const pcf_shaders[];

// What these files take for a constant: the kernel. A loop whose length is
// known when it is compiled takes half the time (measured). Valid as long as
// the settings.
const char *pcf_constants(PcfSettings *settings);

#endif
