// --moments central: a variance is no weighted mean of variances, so that 2 x 2
// texels are read one by one and merged here and not by the texture unit. The
// texture has no filter, and a border at far depth. (texelFetch() would do, but
// Mesa's software driver takes twice as long for it.)
// needs: merge_two
// offers: moments_between, shadow_map

uniform sampler2DArray shadow_map;  // red, green: mean, variance of the depth

// Not textureSize(shadow_map, level): where neighbouring pixels ask for
// different levels, Mesa's software driver tells them the size of one of them.
ivec2 level_size(int level)
{
    return max(textureSize(shadow_map, 0).xy >> level, ivec2(1));
}

vec2 map_moments(ivec2 texel, int layer, int level)
{
    vec2 middle = (vec2(texel) + 0.5) / vec2(level_size(level));
    return textureLod(shadow_map, vec3(middle, float(layer)), float(level)).rg;
}

vec2 moments_between(vec2 uv, int layer, float level)
{
    int which = int(level);
    vec2 place = uv * vec2(level_size(which)) - 0.5;
    ivec2 corner = ivec2(floor(place));
    vec2 part = place - floor(place);
    vec2 rows[2];
    for (int y = 0; y < 2; y++) {
        rows[y] = merge_two(map_moments(corner + ivec2(0, y), layer, which),
                            map_moments(corner + ivec2(1, y), layer, which),
                            part.x);
    }
    return merge_two(rows[0], rows[1], part.y);
}
