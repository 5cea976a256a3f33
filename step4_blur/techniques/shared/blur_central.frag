// --moments central: blur.frag, but that a variance is no weighted mean of
// variances. The texel in the middle has the largest weight, so the others are
// merged about its mean. The constants are blur.frag's.
// needs: Merge, merge_about, map_texel, radius, weights, merge_add, axis,
//     stored, merge_end
// offers: moments

layout(location = 0) out vec2 moments;

void main()
{
    ivec2 middle = ivec2(gl_FragCoord.xy);
    Merge merge = merge_about(map_texel(middle));
    for (int i = -radius; i <= radius; i++) {
        float weight = weights[i + radius];
        merge_add(merge, weight, map_texel(middle + i * axis));
    }
    moments = stored(merge_end(merge, 1.0));
}
