// A texel holds one depth, which does not vary.

uniform int layer;

float texel_variance(float depth)
{
    return 0.0;
}
