// What passes touch, and how much memory they have.
#include "step1_shadowmap/base/measure/stopwatch.h" // targets_touched
#include "step1_shadowmap/base/seams/technique.h"   // target_texel_bytes

static size_t samples_of(const Target *target)
{
    return target->kind == TARGET_SAMPLES ? (size_t)target->samples : 1;
}

// Of each texel: those that are written, and those that are read for it.
static size_t touched_bytes(const Target *target)
{
    size_t bytes = target_texel_bytes(target) + target->read_bytes;
    if (target->depth) {
        bytes += gl_texel_bytes(GL_DEPTH_COMPONENT32F);
    }
    if (target->reads != NULL) {
        bytes += (size_t)(target->scale * target->scale) *
                 samples_of(target->reads) * target_texel_bytes(target->reads);
    }
    return bytes;
}

// Adds a draw of so many texels: bytes written and read for each of them.
static void touch(Touched *touched, size_t texels, size_t bytes_for_each)
{
    touched->texels += texels;
    touched->bytes += texels * bytes_for_each;
}

void target_touch(Target *target, const Rect *wanted)
{
    size_t texels = (size_t)(wanted->high[0] - wanted->low[0]) *
                    (size_t)(wanted->high[1] - wanted->low[1]);
    touch(&target->touched, samples_of(target) * texels, touched_bytes(target));
}

Touched targets_touched(Targets *targets)
{
    Touched all = {0, 0};
    for (int i = 0; i < targets->count; i++) {
        all.texels += targets->list[i]->touched.texels;
        all.bytes += targets->list[i]->touched.bytes;
        targets->list[i]->touched = (Touched){0, 0};
    }
    return all;
}

// Of what was made; a target that shares a texture has none of its own.
static size_t bytes_of(const Target *target)
{
    size_t texels = (size_t)target->width * (size_t)target->height;
    size_t bytes = 0;
    if (target->shares != NULL || target->textures[0] == 0) {
        return 0;
    }
    for (int level = 0; level == 0 || level < target->levels; level++) {
        bytes += gl_texel_bytes(target->formats[0]) *
                 (size_t)(target->width >> level) *
                 (size_t)(target->height >> level) * samples_of(target) *
                 (size_t)(target->kind == TARGET_LAYERS ? target->layers : 1);
    }
    if (target->depth) {
        bytes +=
            texels * samples_of(target) * gl_texel_bytes(GL_DEPTH_COMPONENT32F);
    }
    return bytes;
}

size_t targets_map_bytes(const Targets *targets)
{
    size_t bytes = 0;
    for (int i = 0; i < targets->count; i++) {
        if (targets->list[i]->kind != TARGET_PICTURE) {
            bytes += bytes_of(targets->list[i]);
        }
    }
    return bytes;
}
