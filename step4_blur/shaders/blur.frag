// Half of a separable blur: along one axis, then along the other, costs
// 2 n texels where the square of n x n texels costs n^2.

uniform ivec2 axis;         // (1, 0) along u, (0, 1) along v
uniform ivec2 sides;        // texels before and after the one in the middle
uniform sampler2D weights;  // red: one for each, they add up to 1

layout(location = 0) out vec2 moments;

void main()
{
    ivec2 middle = ivec2(gl_FragCoord.xy);
    Merge merge = merge_about(map_texel(middle));
    for (int i = -sides.x; i <= sides.y; i++) {
        float weight = texelFetch(weights, ivec2(i + sides.x, 0), 0).r;
        merge_add(merge, weight, map_texel(middle + i * axis));
    }
    moments = stored(merge_end(merge, 1.0));
}
