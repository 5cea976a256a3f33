// --min-variance auto, of M1 and M2: what rounding can have taken from the
// variance is added to it, what it can have taken from the mean is added too.
// guard.h proves that p is then never below the lit share.
//
// chebyshev.c puts constants in front:
//     const vec2 guard_variance;  of M2, and whatever the moments are
//     const vec2 guard_mean;      of M1, and whatever the moments are

// The mean and the variance of the depths, at most.
vec2 guarded(vec2 moments, Receiver receiver)
{
    vec2 more = vec2(guard_mean.x, guard_variance.x) * moments +
                vec2(guard_mean.y, guard_variance.y);
    return vec2(moments.x, max(variance_of(moments), 0.0)) + more;
}
