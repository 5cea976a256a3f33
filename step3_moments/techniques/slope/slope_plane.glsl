// --slope-from plane: how the depth changes on the triangle's own plane, per
// texel: M2 += 1/4 (dz/dx^2 + dz/dy^2). That is the variance of a plane's depth
// under a Gaussian of standard deviation half a texel. The distance from a spot
// or point light is not linear in the map, even on a plane: this is its slope
// at one place in the texel.
// needs: map_from_relative, map_gradient, depth_gradient, relative_position;
//     from slope.c:
//     const vec2 slope_map_size;  texels
// offers: slope_variance, layer

uniform int layer;

flat in vec3 plane_normal;

// As depth_slope(), but nearer to edge on: moments_of() limits what it gives.
vec2 plane_slope(vec3 relative_position, vec3 normal)
{
    vec4 map_position = map_from_relative[layer] * vec4(relative_position, 1.0);
    vec3 u = map_gradient(map_position, layer, 0);
    vec3 v = map_gradient(map_position, layer, 1);
    vec3 t = depth_gradient(relative_position, layer);
    vec3 ray = cross(u, v);
    float facing = max(abs(dot(normal, ray)), 1e-5 * length(ray));
    return vec2(dot(t, cross(v, normal)), -dot(t, cross(u, normal))) / facing;
}

float slope_variance(float depth)
{
    vec2 per_texel =
        plane_slope(relative_position, plane_normal) / slope_map_size;
    return 0.25 * dot(per_texel, per_texel);
}
