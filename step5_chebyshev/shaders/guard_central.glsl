// --min-variance auto, of mean and variance: what rounding can have taken from
// the standard deviation is added to it, what it can have taken from the mean
// is added too. guard.h proves that p is then never below the lit share.
//
// chebyshev.c puts constants in front:
//     const float guard_spread;   of the deviation
//     const vec2 guard_variance;  of the root of M2 (to the deviation);
//                                 underflow
//     const vec2 guard_mean;      of M1; underflow

// From 1/2 to 1 all floats are equally far apart: rounding moves them by no
// larger a part of 1/2.
const float rounded_most = 0.5;

// So little is added that a lit surface can be behind itself: map and picture
// interpolate its position, and OpenGL does not say how well. No more than by 8
// units of 2^-24 of its distance from the camera (measured: 7.4). Where the
// deviation is 8 times that, 1.5 % of the light is lost at worst.
const float position_deviation = 64.0 / 16777216.0;

float depth_deviation(Receiver receiver)
{
    vec3 position = receiver.relative_position;
    float steepness = length(depth_gradient(position, receiver.layer));
    return position_deviation * steepness * length(position);
}

// The mean and the variance of the depths, at most.
vec2 guarded(vec2 moments, Receiver receiver)
{
    float variance = variance_of(moments);
    float size = min(sqrt(moments.x * moments.x + variance), rounded_most);
    float mean = min(moments.x, rounded_most);
    // What underflow took is inside the root, which magnifies it.
    float deviation = sqrt(variance + guard_variance.y);
    float spread = guard_spread * deviation;
    deviation += spread + (guard_variance.x * size + guard_mean.y);
    float own = depth_deviation(receiver);
    return vec2(moments.x + (guard_mean.x * mean + spread + guard_mean.y),
                deviation * deviation + own * own);
}
