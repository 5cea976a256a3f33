// A texel holds one depth, which does not vary.
// needs: nothing
// offers: texel_variance, layer

uniform int layer;

float texel_variance(float depth)
{
    return 0.0;
}
