// Step 2: compare first, then average. Reeves, Salesin, Cook, Rendering
// antialiased shadows with depth maps, SIGGRAPH 1987.

uniform sampler2DArray shadow_map;  // red: depth in [0, 1]
uniform int kernel;                 // n of n x n texels, odd

float occluder_depth(ivec2 texel, int layer)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    bool inside = all(greaterThanEqual(texel, ivec2(0))) &&
                  all(lessThan(texel, size));
    // What the map does not hold is at far depth.
    return inside ? texelFetch(shadow_map, ivec3(texel, layer), 0).r : 1.0;
}

float visibility(Receiver receiver)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    ivec2 middle = min(ivec2(receiver.uv * vec2(size)), size - 1);
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
