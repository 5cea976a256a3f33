// The next level of the mip-map chain: half as wide, half as high. A box of
// 2 x 2 texels would keep corners that a coarse level then shows as squares;
// 1 3 3 1 over 8 along each axis is a box of 2 over a tent, so it is smoother.
// needs: Merge, merge_about, map_texel, merge_add, stored, merge_end
// offers: moments

layout(location = 0) out vec2 moments;

void main()
{
    const vec4 weights = vec4(1.0, 3.0, 3.0, 1.0) / 8.0;
    ivec2 corner = 2 * ivec2(gl_FragCoord.xy) - 1;
    Merge merge = merge_about(map_texel(corner + 1));
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 4; x++) {
            float weight = weights[x] * weights[y];
            merge_add(merge, weight, map_texel(corner + ivec2(x, y)));
        }
    }
    moments = stored(merge_end(merge, 1.0));
}
