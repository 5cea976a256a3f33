// Reading a shadow map whose outside is at far depth.

uniform sampler2DArray shadow_map;  // red: depth in [0, 1]

float occluder_depth(ivec2 texel, int layer)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    bool inside = all(greaterThanEqual(texel, ivec2(0))) &&
                  all(lessThan(texel, size));
    return inside ? texelFetch(shadow_map, ivec3(texel, layer), 0).r : 1.0;
}
