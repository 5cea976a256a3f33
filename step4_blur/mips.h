// Step 4, --mips: coarser copies of the filtered map, for pixels that cover
// many of its texels.
#ifndef STEP4_MIPS_H
#define STEP4_MIPS_H

#include "step1_shadowmap/base/picture/frame.h" // Frame

enum { MIPS_MAX_LEVELS = 16 };

// What --plan calls the pass.
extern const char mips_pass[];

// The levels of the texture of a filtered map, level 0 among them.
typedef struct Mips {
    Program *program;
    Target *map;                     // level 0
    Target targets[MIPS_MAX_LEVELS]; // from level 1 on
    int levels;                      // 0: there is no chain
    int anisotropy; // taps of the texture unit; 0: it does not look them up
} Mips;

// How many levels there are of a texture of this size.
int mips_count(const int size[2]);

// Adds the levels to a texture: that of `owner`, which a filtered map has, and
// which is not made yet. Each level is half as wide and high as the one before;
// the last is the one that cannot be halved without a rest, for a texel that
// began elsewhere than two finer ones would shift the shadows. The picture
// looks them up as far as level `last`, so many texels to each side. The
// program is that of mips.frag.
void mips_create(Mips *mips, Frame *frame, Program *program, Target *owner,
                 Target *map, int last, int looked_up);

// Refuses (status 2) what the texture unit cannot do, when it is to blend two
// levels by itself with up to `anisotropy` taps along a pixel's longer axis: so
// many, and in a map of several layers any.
void mips_check_sampler(int layers, int anisotropy);

// The coarsest level that the texture unit reads.
void mips_limit_sampler(const Mips *mips, int last);

// Fills levels 1 and on, each from the one before.
void mips_apply(Mips *mips, const Frame *frame);

#endif
