// Where all that a parallel light's map holds of what is looked up is one
// plane, which cannot shadow itself.
#ifndef BASE_LONE_PLANE_H
#define BASE_LONE_PLANE_H

#include "step1_shadowmap/base/picture/frame.h" // Frame

// Whether lookups of the texels that receivers lie in find nothing but one
// parallelogram in each layer, in every texel, neither at the near nor at the
// far plane, and this is lit for certain. `why` is for --plan. Nothing but the
// frame is looked at: not whether a later one may see other things.
bool lone_plane_is_lit(const Frame *frame, const char **why);

#endif
