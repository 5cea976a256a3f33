// Which filters a blur is made of, one after the other along an axis.
#ifndef STEP4_KERNELS_H
#define STEP4_KERNELS_H

#include "step1_shadowmap/base/picture/frame.h" // Frame

enum { KERNELS_MAX_FILTERS = 3, KERNELS_MAX_WIDTH = 2 * 1024 + 1 };

// How many texels a filter holds before and after the one in its middle.
typedef struct KernelSides {
    int sides[2];
} KernelSides;

// How many there are with the frame's options, and which: none at radius 0;
// else one, the radius to both sides; of --blur boxes three, and two at radius
// 1. These are as alike as can be and reach, one after the other, as far as the
// radius.
int kernels_filters(const Frame *frame,
                    KernelSides filters[KERNELS_MAX_FILTERS]);

// The weights of a filter, one for each texel that it holds, which add up to 1
// up to rounding: those of a box or of one of several boxes (all equal),
// gaussian (standard deviation radius / 3, cut at the radius) or binomial (row
// 2 radius of Pascal's triangle; for radius 3 it is 1 6 15 20 15 6 1, over 64).
void kernels_weights(const int sides[2], float weights[]);

#endif
