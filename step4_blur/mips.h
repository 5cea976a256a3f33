// Step 4, --mips: coarser copies of the filtered map, for pixels that cover
// many of its texels.
#ifndef STEP4_MIPS_H
#define STEP4_MIPS_H

#include "step1_shadowmap/map_plan.h"   // MapPlan
#include "step1_shadowmap/shadow_map.h" // ShadowMap

enum { MIPS_MAX_LEVELS = 16 };

// The levels of a texture that somebody else owns, level 0 among them.
typedef struct Mips {
    Program program;
    GLuint texture;
    GLuint framebuffers[MIPS_MAX_LEVELS][VIEW_MAX_LAYERS]; // none for level 0
    int width, height, layers;                             // of level 0
    int levels; // 0: there is no chain
    size_t bytes;
} Mips;

// How many levels there are of a texture of this size.
int mips_count(const int size[2]);

// Adds the levels to an array texture that is like the map's but of this size.
// Each is half as wide and high as the one before; the last is the one that
// cannot be halved without a rest, for a texel that began elsewhere than two
// finer ones would shift the shadows. The program (of mips.frag) is the chain's
// from here on.
Mips mips_create(Program program, GLuint texture, const ShadowMap *map,
                 const int size[2]);

// From here on the texture unit blends two levels by itself, with up to
// `anisotropy` taps along a pixel's longer axis. Refuses (status 2) what the
// driver cannot do, and such taps in a map of several layers.
void mips_use_sampler(const Mips *mips, int anisotropy);

// The coarsest level that the texture unit reads.
void mips_limit_sampler(const Mips *mips, int last);

// Fills levels 1 and on, each from the one before: of the layers that the plan
// draws, in each level those texels.
void mips_apply(const Mips *mips, GLuint texture, GLuint empty_vao,
                const Rect levels[][VIEW_MAX_LAYERS], const MapPlan *plan);

// Writes level K >= 1 of layer L as directory/blurred.L.mK.exr.
void mips_dump(const Mips *mips, GLuint texture, const char *directory);

void mips_destroy(Mips *mips);

#endif
