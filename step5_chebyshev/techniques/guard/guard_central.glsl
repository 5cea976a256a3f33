// --min-variance auto, of mean and variance: what rounding can have taken from
// the standard deviation is added to it, what it can have taken from the mean
// is added too. proof.md shows that p is then never below the lit share.
// needs: Receiver, depth_gradient, variance_of; from guard_settings.c:
//     const float chain_spread;   of the deviation
//     const vec2 chain_variance;  of the root of M2 (to the deviation);
//                                 underflow
//     const vec2 chain_mean;      of M1; underflow
// offers: guarded

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
    float deviation = sqrt(variance + chain_variance.y);
    float spread = chain_spread * deviation;
    deviation += spread + (chain_variance.x * size + chain_mean.y);
    float own = depth_deviation(receiver);
    return vec2(moments.x + (chain_mean.x * mean + spread + chain_mean.y),
                deviation * deviation + own * own);
}
