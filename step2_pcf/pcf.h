// Step 2: percentage-closer filtering.
#ifndef STEP2_PCF_H
#define STEP2_PCF_H

#include "step1_shadowmap/base/system/options.h" // Option
#include "step1_shadowmap/shadow_map.h"          // BiasSettings

typedef struct PcfSettings {
    int kernel; // n of n x n taps, odd
} PcfSettings;

extern const Option pcf_options[];

PcfSettings pcf_settings(void);

// The picture's lookups, each of n x n texels.
Lookups pcf_lookups(const PcfSettings *settings, const BiasSettings *bias);

// The shader files that define visibility(); NULL at the end.
extern const char *const pcf_shaders[];

enum { PCF_CONSTANTS_BYTES = 32 };

// What these files take for a constant: the kernel. A loop whose length is
// known when it is compiled takes half the time (measured).
void pcf_constants(const PcfSettings *settings, char text[PCF_CONSTANTS_BYTES]);

#endif
