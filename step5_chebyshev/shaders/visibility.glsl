// What of the light arrives, at most, by the moments of the depths around.
//
// M2 - M1 * M1 is a small difference of two large, rounded numbers and can come
// out too small. So we add the most that rounding can have taken from it, and
// the same to the mean: the bound is then never below the lit share
// (--min-variance auto). Or the variance is at least a constant that somebody
// found by looking (--min-variance X), as in most published programs.
// needs: Receiver, moments_at, reduce_bleeding, chebyshev; from chebyshev.c:
//     const vec2 guard_mean;      the part of M1, and a constant
//     const vec2 guard_variance;  the part of M2, and a constant
//     const float min_variance;   of the squared depth range
// offers: visibility

float visibility(Receiver receiver)
{
    vec2 moments = moments_at(receiver);
    float M1 = moments.x;
    float M2 = moments.y;
    float variance = max(M2 - M1 * M1, min_variance);
    float mean = M1 + (guard_mean.x * M1 + guard_mean.y);
    variance += guard_variance.x * M2 + guard_variance.y;
    return reduce_bleeding(chebyshev(mean, variance, receiver.depth));
}
