#include "step3_moments/techniques/shared/shared.h"

#include <stddef.h> // NULL

const char *const moments_merged[] = {
    "step3_moments/techniques/shared/position.glsl",
    "step3_moments/techniques/shared/flat.glsl",
    "step3_moments/techniques/shared/merge_raw.glsl",
    "step3_moments/techniques/shared/store_float.glsl",
    "step3_moments/techniques/shared/moments_merged.frag",
    NULL};

const char *const lookup_between[] = {
    "step3_moments/techniques/shared/merge_raw.glsl",
    "step3_moments/techniques/shared/between_raw.glsl",
    "step3_moments/techniques/shared/lookup_between.glsl", NULL};
