// --msaa: several samples per texel while the map is drawn, then their moments.
#ifndef STEP3_MULTISAMPLE_H
#define STEP3_MULTISAMPLE_H

#include "step3_moments/moments.h" // Moments

// Adds the target of the samples, which that of the moments reads. When it is
// drawn, a number of samples that this driver does not have is refused (status
// 2).
void multisample_create(Moments *moments, Frame *frame);

// Draws the samples of a layer, and their moments. With --dump it writes sample
// S of layer L as samples.L.S.exr.
void multisample_draw_layer(Moments *moments, const Frame *frame, int layer);

// Writes sample_positions.exr into the directory, of one row: where each sample
// lies in a texel, x and y in [0, 1], y upwards.
void multisample_dump_positions(const Moments *moments, const char *directory);

#endif
