// Steps 3 and 4: one comparison with the mean depth. A mean is not a depth of
// anything: this is what step 5 mends.
// needs: Receiver, shadow_map, comparison_bias, moments_at
// offers: visibility

float visibility(Receiver receiver)
{
    vec2 size = vec2(textureSize(shadow_map, 0).xy);
    float bias = comparison_bias(receiver, 1, size);
    return receiver.depth - bias <= moments_at(receiver).x ? 1.0 : 0.0;
}
