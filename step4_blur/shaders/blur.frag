// Half of a separable blur: along one axis, then along the other, costs
// 2 n texels where the square of n x n texels costs n^2. Moments are means, so
// their weighted mean is the moment of all these texels.
// needs: map_texel; from blur.c:
//     const ivec2 axis;       (1, 0) along u, (0, 1) along v
//     const int radius;       texels to each side of the one in the middle
//     const float weights[];  one for each, they add up to 1
// offers: moments

layout(location = 0) out vec2 moments;

void main()
{
    ivec2 middle = ivec2(gl_FragCoord.xy);
    moments = vec2(0.0);
    for (int i = -radius; i <= radius; i++) {
        moments += weights[i + radius] * map_texel(middle + i * axis);
    }
}
