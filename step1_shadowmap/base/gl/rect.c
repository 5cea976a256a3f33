#include "step1_shadowmap/base/gl/rect.h"

Rect rect_whole(int width, int height)
{
    return (Rect){{0, 0}, {width, height}};
}

bool rect_is_empty(const Rect *rect)
{
    return rect->low[0] >= rect->high[0] || rect->low[1] >= rect->high[1];
}

size_t rect_texels(const Rect *rect)
{
    return rect_is_empty(rect) ? 0
                               : (size_t)(rect->high[0] - rect->low[0]) *
                                     (size_t)(rect->high[1] - rect->low[1]);
}
