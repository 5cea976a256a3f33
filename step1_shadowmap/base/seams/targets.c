// How a technique takes part among the targets.
#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h" // target_add_before

void target_add_before(Targets *targets, Target *target, const Target *before)
{
    int place = 0;
    while (place < targets->count && targets->list[place] != before) {
        place++;
    }
    target_insert(targets, place, target);
}

Target *targets_find(const Targets *targets, const char *pass)
{
    for (int i = 0; i < targets->count; i++) {
        const char *name = targets->list[i]->pass;
        if (name != NULL && strcmp(name, pass) == 0) {
            return targets->list[i];
        }
    }
    return NULL;
}

void target_take_place(Target *target, Target *other)
{
    const char *file = target->file;
    int looked_up = target->looked_up;
    *target = target_alias(other);
    target->file = file;
    target->looked_up = looked_up;
    target_want_all(target);
}

size_t target_texel_bytes(const Target *target)
{
    size_t bytes = 0;
    for (int i = 0; i < TARGET_MAX_OUTPUTS; i++) {
        bytes += gl_texel_bytes(target->formats[i]);
    }
    return bytes;
}
