// How much nearer to the light a receiver is taken to be, so that a surface
// does not shadow itself: a texel holds one depth for a whole patch of it.

uniform float bias;        // of the depth range
uniform float slope_bias;  // of the depth change across half the kernel

// Row i of the matrix to (u w, v w, z w, w), without the translation.
vec3 map_axis(int layer, int i)
{
    mat4 m = map_from_relative[layer];
    return vec3(m[0][i], m[1][i], m[2][i]);
}

// How u (axis 0) or v (axis 1), that is a quotient, changes with the position.
vec3 map_gradient(Receiver receiver, int axis)
{
    int layer = receiver.layer;
    vec4 row = vec4(map_axis(layer, 3), map_from_relative[layer][3][3]);
    float w = dot(row, vec4(receiver.relative_position, 1.0));
    return (map_axis(layer, axis) - receiver.uv[axis] * row.xyz) / w;
}

// |dt/du| and |dt/dv| on the receiver's plane. A step in that plane that keeps
// v is across the normal and across v's gradient; what t and u gain by it are
// in the ratio dt/du. `ray` points along the light's ray, where u and v do not
// change. That ray meets the plane at an angle whose sine is held at 0.02, else
// the ratio has no limit.
vec2 depth_slope(Receiver receiver)
{
    vec3 u = map_gradient(receiver, 0);
    vec3 v = map_gradient(receiver, 1);
    vec3 t = depth_gradient(receiver.relative_position, receiver.layer);
    vec3 ray = cross(u, v);
    float facing = max(abs(dot(receiver.normal, ray)), 0.02 * length(ray));
    return abs(vec2(dot(t, cross(v, receiver.normal)),
                    dot(t, cross(u, receiver.normal)))) / facing;
}

// For a comparison with kernel x kernel texels of a map of map_size texels:
// along each axis the furthest texel centre is at most kernel / 2 texels from
// the receiver; half a texel more is margin.
float comparison_bias(Receiver receiver, int kernel, vec2 map_size)
{
    vec2 per_texel = depth_slope(receiver) / map_size;
    float half_kernel = 0.5 * float(kernel + 1);
    return bias + slope_bias * half_kernel * (per_texel.x + per_texel.y);
}
