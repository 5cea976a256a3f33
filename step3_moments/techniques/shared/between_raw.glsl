// --moments raw: the moments between the texels of a level are weighted means,
// which is what the texture unit makes of 2 x 2 texels. Outside is far depth.
// needs: nothing
// offers: moments_between, shadow_map

uniform sampler2DArray shadow_map;  // red, green: moments M1, M2 of the depth

vec2 moments_between(vec2 uv, int layer, float level)
{
    return textureLod(shadow_map, vec3(uv, float(layer)), level).rg;
}
