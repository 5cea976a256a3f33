// --moments central: the mean and the variance of the depth's distribution. One
// texel holds one depth, which does not vary.

uniform int layer;

layout(location = 0) out vec2 moments;

void main()
{
    float depth = map_depth(relative_position, layer);
    moments = stored(moments_of(depth, 0.0));
}
