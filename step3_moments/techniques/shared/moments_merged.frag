// In place of moments.frag: the moments of the depths in a texel as another
// file keeps them, with a variance that another one knows.
// needs: map_depth, relative_position, layer, stored, moments_of,
//     texel_variance
// offers: moments

layout(location = 0) out vec2 moments;

void main()
{
    float depth = map_depth(relative_position, layer);
    moments = stored(moments_of(depth, texel_variance(depth)));
}
