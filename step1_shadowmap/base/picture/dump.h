// What --dump writes: every intermediate map.
#ifndef BASE_DUMP_H
#define BASE_DUMP_H

#include "step1_shadowmap/base/picture/frame.h" // Frame

// Writes directory/name.exr.
void dump_image(const char *directory, const char *name, const float *pixels,
                int width, int height, int channels);

// Writes every layer L of a target's texture as directory/file.L.exr, or of its
// level K as directory/file.L.mK.exr.
void dump_target(Target *target, const char *directory);

#endif
