// What of the light arrives, at most. The variance is at least what
// --min-variance says.

float visibility(Receiver receiver)
{
    vec2 depths = guarded(moments_at(receiver), receiver);
    float variance = min(depths.y + variance_bias, 1.0);
    return reduce_bleeding(chebyshev(depths.x, variance, receiver.depth));
}
