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
static inline Rect rect_whole(int width, int height)
{
    return (Rect){{0, 0}, {width, height}};
}

static inline bool rect_is_empty(const Rect *rect)
{
    return rect->low[0] >= rect->high[0] || rect->low[1] >= rect->high[1];
}

// How many texels it has.
static inline size_t rect_texels(const Rect *rect)
{
    return rect_is_empty(rect) ? 0
                               : (size_t)(rect->high[0] - rect->low[0]) *
                                     (size_t)(rect->high[1] - rect->low[1]);
}

#endif
