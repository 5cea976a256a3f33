// --slope-from plane: how the depth changes on the triangle's own plane, per
// texel: M2 += 1/4 (dz/dx^2 + dz/dy^2). That is the variance of a plane's depth
// under a Gaussian of standard deviation half a texel. The distance from a spot
// or point light is not linear in the map, even on a plane: this is its slope
// at one place in the texel.
//
// slope.c puts in front, a constant:
//     const vec2 slope_map_size;  texels

uniform int layer;

flat in vec3 plane_normal;

float slope_variance(float depth)
{
    vec2 per_texel =
        depth_slope(relative_position, plane_normal, layer, 1e-5) / slope_map_size;
    return 0.25 * dot(per_texel, per_texel);
}
