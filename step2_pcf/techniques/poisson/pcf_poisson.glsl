// --pattern poisson: the taps are spread over a disc as wide as the grid.
// needs: Receiver, shadow_map, filter_width, comparison_bias, POISSON_TAPS,
//     poisson_tap, occluder_depth
// offers: visibility

float visibility(Receiver receiver)
{
    vec2 size = vec2(textureSize(shadow_map, 0).xy);
    int width = filter_width(receiver);
    float bias = comparison_bias(receiver, width, size);
    float lit = 0.0;
    for (int i = 0; i < POISSON_TAPS; i++) {
        vec2 place = receiver.uv * size + 0.5 * float(width) * poisson_tap(i);
        float occluder =
            occluder_depth(ivec2(floor(place)), receiver.layer);
        lit += receiver.depth - bias <= occluder ? 1.0 : 0.0;
    }
    return lit / float(POISSON_TAPS);
}
