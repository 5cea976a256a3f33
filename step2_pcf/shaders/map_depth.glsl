// Reads single texels of a shadow map. Its texture has no filter, and far depth
// as its border. (texelFetch() would do, but Mesa's software driver takes twice
// as long for it.)
// needs: nothing
// offers: occluder_depth, shadow_map

uniform sampler2DArray shadow_map;  // red: depth in [0, 1]

float occluder_depth(ivec2 texel, int layer)
{
    vec2 size = vec2(textureSize(shadow_map, 0).xy);
    vec2 middle = (vec2(texel) + 0.5) / size;
    return textureLod(shadow_map, vec3(middle, float(layer)), 0.0).r;
}
