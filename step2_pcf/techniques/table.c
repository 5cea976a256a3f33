// The techniques of step 2.
#include "step1_shadowmap/base/picture/technique.h"

extern const Technique pcf_adaptive, pcf_poisson, pcf_bilinear;

const Technique *const techniques[] = {&pcf_adaptive, &pcf_poisson,
                                       &pcf_bilinear, NULL};
