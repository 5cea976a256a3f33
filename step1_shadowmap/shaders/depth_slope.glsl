// How t changes across the map on the plane of a surface.
// needs: map_from_relative, depth_gradient
// offers: map_gradient, depth_slope

// Gradient of u = x / w (axis 0) or v = y / w (axis 1): u' = (x' - u w') / w.
vec3 map_gradient(vec4 map_position, int layer, int axis)
{
    mat4 rows = transpose(map_from_relative[layer]);
    float quotient = map_position[axis] / map_position.w;
    return (rows[axis].xyz - quotient * rows[3].xyz) / map_position.w;
}

// dt/du and dt/dv on the plane through the position, with the normal n. A step
// s = v' x n stays in it and keeps v. So dt/du = (t' . s) / (u' . s), where
// u' . s = n . (u' x v'). The vector u' x v', `ray`, is along the light's ray;
// n . ray is its length times the sine of its angle to the plane. We hold
// that sine at 0.02, else the slope has no limit.
vec2 depth_slope(vec3 relative_position, vec3 normal, int layer)
{
    vec4 map_position = map_from_relative[layer] * vec4(relative_position, 1.0);
    vec3 u = map_gradient(map_position, layer, 0);
    vec3 v = map_gradient(map_position, layer, 1);
    vec3 t = depth_gradient(relative_position, layer);
    vec3 ray = cross(u, v);
    float facing = max(abs(dot(normal, ray)), 0.02 * length(ray));
    return vec2(dot(t, cross(v, normal)), -dot(t, cross(u, normal))) / facing;
}
