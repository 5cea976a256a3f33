// A running sum along each row, one row for each invocation: n additions where
// recursive doubling reads 4 texels in each of log4(n) passes.
// needs: nearness_steps, map_texel, layer
// offers: table

layout(local_size_x = 64) in;

layout(rg32ui) writeonly uniform uimage2DArray table;
uniform ivec2 first;  // texels that are summed: from here
uniform ivec2 end;    // up to here

void main()
{
    ivec2 texel = first + ivec2(0, gl_GlobalInvocationID.x);
    uvec2 sum = uvec2(0u);
    for (; texel.y < end.y && texel.x < end.x; texel.x++) {
        sum += nearness_steps(map_texel(texel));
        imageStore(table, ivec3(texel, layer), uvec4(sum, 0u, 0u));
    }
}
