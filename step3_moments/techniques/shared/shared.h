// What several techniques put in the place of the lesson's shaders.
#ifndef STEP3_SHARED_H
#define STEP3_SHARED_H

// In place of moments.frag: it says where the position comes from, how the
// depth varies across a texel, how moments are merged and what a texel keeps of
// them, in a file each. Techniques put others in the place of these.
extern const char *const moments_merged[];

// The same in place of lookup_bilinear.glsl: merging, and what is between
// texels.
extern const char *const lookup_between[];

#endif
