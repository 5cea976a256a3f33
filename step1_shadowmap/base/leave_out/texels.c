#include "step1_shadowmap/base/leave_out/texels.h"

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int greatest(int a, int b)
{
    return a > b ? a : b;
}

Rect rect_grow(const Rect *rect, int along_u, int along_v, const int size[2])
{
    const int by[2] = {along_u, along_v};
    Rect result = {{0, 0}, {0, 0}};
    for (int axis = 0; axis < 2 && !rect_is_empty(rect); axis++) {
        result.low[axis] = greatest(rect->low[axis] - by[axis], 0);
        result.high[axis] = least(rect->high[axis] + by[axis], size[axis]);
    }
    return result;
}

Rect rect_divide(const Rect *rect, int factor)
{
    Rect result = {{0, 0}, {0, 0}};
    for (int axis = 0; axis < 2 && !rect_is_empty(rect); axis++) {
        result.low[axis] = rect->low[axis] / factor;
        result.high[axis] = (rect->high[axis] + factor - 1) / factor;
    }
    return result;
}

Rect rect_multiply(const Rect *rect, int factor)
{
    Rect result = *rect;
    for (int axis = 0; axis < 2; axis++) {
        result.low[axis] *= factor;
        result.high[axis] *= factor;
    }
    return result;
}

Rect rect_join(const Rect *a, const Rect *b)
{
    if (rect_is_empty(a) || rect_is_empty(b)) {
        return rect_is_empty(a) ? *b : *a;
    }
    Rect result;
    for (int axis = 0; axis < 2; axis++) {
        result.low[axis] = least(a->low[axis], b->low[axis]);
        result.high[axis] = greatest(a->high[axis], b->high[axis]);
    }
    return result;
}

bool rect_holds(const Rect *outer, const Rect *inner)
{
    bool holds = true;
    for (int axis = 0; axis < 2; axis++) {
        holds = holds && outer->low[axis] <= inner->low[axis] &&
                outer->high[axis] >= inner->high[axis];
    }
    return holds || rect_is_empty(inner);
}
