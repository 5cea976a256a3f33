// What passes read of each other: rectangles of texels, grown and joined.
#ifndef BASE_TEXELS_H
#define BASE_TEXELS_H

#include "step1_shadowmap/base/gl/rect.h" // Rect

// Wider by so many texels to each side along u and v, but no wider than a map
// of this size. What is empty stays empty.
Rect rect_grow(const Rect *rect, int along_u, int along_v, const int size[2]);

// The texels of a map that is smaller by a factor which hold these.
Rect rect_divide(const Rect *rect, int factor);

// The texels of a map that is larger by a factor which these hold.
Rect rect_multiply(const Rect *rect, int factor);

// The smallest rectangle around both.
Rect rect_join(const Rect *a, const Rect *b);

// Whether all texels of the inner one are in the outer one.
bool rect_holds(const Rect *outer, const Rect *inner);

#endif
