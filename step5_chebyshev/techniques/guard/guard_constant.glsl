// --min-variance X: what all published programs do. The variance is a small
// difference of two rounded numbers and can come out too small, or negative. So
// it is at least a constant that somebody found by looking.
// needs: Receiver, variance_of; from chebyshev.c:
//     const float min_variance;  of the squared depth range
// offers: guarded

// The mean and the variance of the depths.
vec2 guarded(vec2 moments, Receiver receiver)
{
    return vec2(moments.x, max(variance_of(moments), min_variance));
}
