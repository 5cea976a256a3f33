// The first table: what there is to sum.
// needs: nearness_steps, map_texel
// offers: sums

layout(location = 0) out uvec2 sums;

void main()
{
    sums = nearness_steps(map_texel(ivec2(gl_FragCoord.xy)));
}
