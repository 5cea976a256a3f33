// --msaa: the moments of a texel are those of its samples together. (Depths
// cannot be averaged: this is why a depth map has no --msaa.)
// needs: Merge, merge_about, merge_add, stored, merge_end
// offers: moments

uniform sampler2DMS samples;
uniform int count;  // of samples

layout(location = 0) out vec2 moments;

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    Merge merge = merge_about(texelFetch(samples, texel, 0).rg);
    for (int i = 0; i < count; i++) {
        merge_add(merge, 1.0, texelFetch(samples, texel, i).rg);
    }
    moments = stored(merge_end(merge, float(count)));
}
