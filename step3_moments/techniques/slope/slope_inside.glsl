// --slope-term: the moments of the depths across a texel, not only of the one
// in its middle. What map_depth() cut off at 0 or 1 is flat there. moments_of()
// limits the slope of what the light sees edge on.
// needs: slope_variance
// offers: texel_variance

float texel_variance(float depth)
{
    return depth > 0.0 && depth < 1.0 ? slope_variance(depth) : 0.0;
}
