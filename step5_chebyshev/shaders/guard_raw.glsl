// --min-variance auto: the variance is a small difference of two large, rounded
// numbers and can come out too small. So we add the most that rounding can have
// taken from it. We add the same to the mean. guard.h proves that the bound p is
// then never below the lit share.
//
// chebyshev.c puts these constants in front:
//     const vec2 guard_mean;      the part of M1, and a constant
//     const vec2 guard_variance;  the part of M2, and a constant

// The mean and the variance of the depths, at most.
vec2 guarded(vec2 moments, Receiver receiver)
{
    float M1 = moments.x;
    float M2 = moments.y;
    float variance = max(M2 - M1 * M1, 0.0);
    return vec2(M1 + (guard_mean.x * M1 + guard_mean.y),
                variance + (guard_variance.x * M2 + guard_variance.y));
}
