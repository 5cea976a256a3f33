// --adaptive: the lesson's filter (pcf.glsl), of the width that filter_width()
// says.
// needs: Receiver, shadow_map, filter_width, comparison_bias, occluder_depth
// offers: visibility

float visibility(Receiver receiver)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    ivec2 middle = min(ivec2(receiver.uv * vec2(size)), size - 1);
    int width = filter_width(receiver);
    float bias = comparison_bias(receiver, width, vec2(size));
    int radius = width / 2;
    float lit = 0.0;
    for (int y = -radius; y <= radius; y++) {
        for (int x = -radius; x <= radius; x++) {
            float occluder =
                occluder_depth(middle + ivec2(x, y), receiver.layer);
            lit += receiver.depth - bias <= occluder ? 1.0 : 0.0;
        }
    }
    return lit / float(width * width);
}
