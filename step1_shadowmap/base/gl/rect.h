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

#endif
