// How t changes across the map on the plane of a surface.
// needs: map_from_relative, depth_gradient
// offers: map_gradient, depth_slope

// How u (axis 0) or v (axis 1), that is a quotient, changes with the position.
vec3 map_gradient(vec4 map_position, int layer, int axis)
{
    mat4 rows = transpose(map_from_relative[layer]);
    float quotient = map_position[axis] / map_position.w;
    return (rows[axis].xyz - quotient * rows[3].xyz) / map_position.w;
}

// dt/du and dt/dv on the plane through the position, across the normal. A step
// in that plane that keeps v is across the normal and across v's gradient; what
// t and u gain by it are in the ratio dt/du. `ray` points along the light's
// ray, where u and v do not change. That ray meets the plane at an angle whose
// sine is held at 0.02, else the ratio has no limit.
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
