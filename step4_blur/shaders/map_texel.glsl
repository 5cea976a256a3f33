// Reading a map whose outside is at far depth.

uniform sampler2DArray map;  // red, green: moments of the depth
uniform int layer;

vec2 map_texel(ivec2 texel)
{
    ivec2 size = textureSize(map, 0).xy;
    bool inside = all(greaterThanEqual(texel, ivec2(0))) &&
                  all(lessThan(texel, size));
    return inside ? texelFetch(map, ivec3(texel, layer), 0).rg : far_moments;
}
