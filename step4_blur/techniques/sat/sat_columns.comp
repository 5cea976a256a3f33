// Then along each column, in place. Whole numbers wrap around at 2^32 in any
// order of summing, so this is the same table to the last bit.
// needs: nothing
// offers: table

layout(local_size_x = 64) in;

layout(rg32ui) uniform uimage2DArray table;
uniform int layer;
uniform ivec2 first;  // texels that are summed: from here
uniform ivec2 end;    // up to here

void main()
{
    ivec2 texel = first + ivec2(gl_GlobalInvocationID.x, 0);
    uvec2 sum = uvec2(0u);
    for (; texel.x < end.x && texel.y < end.y; texel.y++) {
        sum += imageLoad(table, ivec3(texel, layer)).rg;
        imageStore(table, ivec3(texel, layer), uvec4(sum, 0u, 0u));
    }
}
