// In place of the lesson's visibility.glsl, where other files know what a texel
// holds and what rounding has done to it.
// needs: Receiver, guarded, moments_at, reduce_bleeding, chebyshev, biased
// offers: visibility

float visibility(Receiver receiver)
{
    vec2 depths = guarded(moments_at(receiver), receiver);
    return reduce_bleeding(
        chebyshev(depths.x, biased(depths.y), receiver.depth));
}
