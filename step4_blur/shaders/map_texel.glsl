// Reading single texels of a map: frame_filter() binds a sampler without a
// filter, with a border at far depth. (texelFetch() would do, but Mesa's
// software driver takes twice as long for it.)
// needs: nothing
// offers: map_texel, layer

uniform sampler2DArray map;  // red, green: moments of the depth
uniform int layer;

vec2 map_texel(ivec2 texel)
{
    vec2 middle = (vec2(texel) + 0.5) / vec2(textureSize(map, 0).xy);
    return textureLod(map, vec3(middle, float(layer)), 0.0).rg;
}
