// Step 2: compare first, then average. Reeves, Salesin, Cook, Rendering
// antialiased shadows with depth maps, SIGGRAPH 1987.
// needs: Receiver, shadow_map, comparison_bias, occluder_depth; from pcf.c:
//     const int kernel;  texels, odd
// offers: visibility

float visibility(Receiver receiver)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    ivec2 middle = min(ivec2(receiver.uv * vec2(size)), size - 1);  // for u = 1
    float bias = comparison_bias(receiver, kernel, vec2(size));
    int radius = kernel / 2;
    float lit = 0.0;
    for (int y = -radius; y <= radius; y++) {
        for (int x = -radius; x <= radius; x++) {
            float occluder =
                occluder_depth(middle + ivec2(x, y), receiver.layer);
            lit += receiver.depth - bias <= occluder ? 1.0 : 0.0;
        }
    }
    return lit / float(kernel * kernel);
}
