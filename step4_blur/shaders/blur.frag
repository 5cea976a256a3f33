// Half of a separable blur: along one axis, then along the other, costs
// 2 n texels where the square of n x n texels costs n^2.

uniform ivec2 axis;         // (1, 0) along u, (0, 1) along v
uniform int radius;         // texels to each side
uniform sampler2D weights;  // red: 2 radius + 1 weights that add up to 1

layout(location = 0) out vec2 moments;

void main()
{
    ivec2 middle = ivec2(gl_FragCoord.xy);
    Merge merge = merge_about(map_texel(middle));
    for (int i = -radius; i <= radius; i++) {
        float weight = texelFetch(weights, ivec2(i + radius, 0), 0).r;
        merge_add(merge, weight, map_texel(middle + i * axis));
    }
    moments = stored(merge_end(merge, 1.0));
}
