// --bilinear: n x n taps, each between four texels, each of these compared on
// its own and weighted as a bilinear lookup weights them. Depths must not be
// interpolated before the comparison. Neighbouring taps share their texels, so
// n x n taps are (n + 1) x (n + 1) comparisons: weight 1 inside, less at the
// rim.
// needs: Receiver, shadow_map, filter_width, comparison_bias, occluder_depth
// offers: visibility

float tap_weight(int i, int width, float part)
{
    if (i == 0) {
        return 1.0 - part;
    }
    return i == width ? part : 1.0;
}

float visibility(Receiver receiver)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    vec2 place = receiver.uv * vec2(size) - 0.5;
    vec2 part = place - floor(place);
    int width = filter_width(receiver);
    ivec2 corner = ivec2(floor(place)) - width / 2;
    float bias = comparison_bias(receiver, width, vec2(size));
    float lit = 0.0;
    for (int y = 0; y <= width; y++) {
        for (int x = 0; x <= width; x++) {
            float occluder =
                occluder_depth(corner + ivec2(x, y), receiver.layer);
            float weight = tap_weight(x, width, part.x) *
                           tap_weight(y, width, part.y);
            lit += receiver.depth - bias <= occluder ? weight : 0.0;
        }
    }
    // The weights add up to n^2 only up to rounding.
    return min(lit / float(width * width), 1.0);
}
