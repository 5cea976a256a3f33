// --slope-from derivatives: what depth a triangle has in the next fragments, as
// published: M2 += 1/4 (dz/dx^2 + dz/dy^2). That is the variance of a plane's
// depth under a Gaussian of standard deviation half a texel.
// needs: light_depth, relative_position
// offers: slope_variance, layer

// A derivative has no value in a branch that a neighbour may not take: so it is
// taken here, before main() begins.
uniform int layer;
vec2 step_depth = vec2(dFdx(light_depth(relative_position, layer)),
                       dFdy(light_depth(relative_position, layer)));

float slope_variance(float depth)
{
    return 0.25 * dot(step_depth, step_depth);
}
