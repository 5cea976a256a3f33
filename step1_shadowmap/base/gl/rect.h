// Rectangles of a map's texels.
#ifndef BASE_RECT_H
#define BASE_RECT_H

#include <stdbool.h>
#include <stddef.h> // size_t

// Texels from low up to, not including, high; none where high is not above low
// along both axes. All zero is empty.
typedef struct Rect {
    int low[2], high[2];
} Rect;

// All of a map of width x height texels.
Rect rect_whole(int width, int height);

bool rect_is_empty(const Rect *rect);

// How many texels it has.
size_t rect_texels(const Rect *rect);

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
