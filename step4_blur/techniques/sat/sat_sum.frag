// Recursive doubling, four at a time: after passes with strides 1, 4, 16, ...
// a texel holds the sum of all up to it along the axis. Hensley and others,
// Fast summed-area table generation and its applications, Eurographics 2005.
// needs: nothing
// offers: sums

uniform usampler2DArray table;
uniform int layer;
uniform ivec2 axis;  // (1, 0) along u, (0, 1) along v
uniform int stride;  // texels
uniform ivec2 first;  // texel that is summed

layout(location = 0) out uvec2 sums;

void main()
{
    sums = uvec2(0u);
    for (int i = 0; i < 4; i++) {
        ivec2 texel = ivec2(gl_FragCoord.xy) - i * stride * axis;
        if (all(greaterThanEqual(texel, first))) {
            sums += texelFetch(table, ivec3(texel, layer), 0).rg;
        }
    }
}
