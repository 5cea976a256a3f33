// --moments central: downsample.frag, merged about the first texel's mean. The
// constant is downsample.frag's.
// needs: factor, Merge, merge_about, map_texel, merge_add, stored, merge_end
// offers: moments

layout(location = 0) out vec2 moments;

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * factor;
    Merge merge = merge_about(map_texel(corner));
    for (int y = 0; y < factor; y++) {
        for (int x = 0; x < factor; x++) {
            merge_add(merge, 1.0, map_texel(corner + ivec2(x, y)));
        }
    }
    moments = stored(merge_end(merge, float(factor * factor)));
}
