// A smaller map: the mean of factor x factor texels. The moments of a group of
// texels are the means of their moments.
// needs: map_texel; from blur.c:
//     const int factor;  of texels along each axis to one
// offers: moments

layout(location = 0) out vec2 moments;

void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * factor;
    vec2 sum = vec2(0.0);
    for (int y = 0; y < factor; y++) {
        for (int x = 0; x < factor; x++) {
            sum += map_texel(corner + ivec2(x, y));
        }
    }
    moments = sum / float(factor * factor);
}
