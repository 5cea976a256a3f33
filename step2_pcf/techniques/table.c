// The techniques of step 2.
#include "step1_shadowmap/base/run/technique.h"

extern const Technique pcf_poisson, pcf_bilinear, pcf_adaptive;

const Technique *const techniques[] = {&pcf_poisson, &pcf_bilinear,
                                       &pcf_adaptive, NULL};
