// How much nearer to the light a receiver is taken to be, so that a surface
// does not shadow itself: a texel holds one depth for a whole patch of it.

uniform float bias;        // of the depth range
uniform float slope_bias;  // of the depth change across half the kernel

// Row i of the matrix that maps to (u, v, t), without the translation.
vec3 map_axis(int layer, int i)
{
    mat4 m = map_from_relative[layer];
    return vec3(m[0][i], m[1][i], m[2][i]);
}

// |dt/du| and |dt/dv| on the receiver's plane. Moving by U/|U|^2 raises u by
// one; to stay on the plane, the point has to move along T as well, until its
// distance to the plane, measured by the normal, is 0 again. The light meets
// the plane at an angle whose sine is held at 0.1, else this has no limit.
vec2 depth_slope(Receiver receiver)
{
    vec3 u = map_axis(receiver.layer, 0);
    vec3 v = map_axis(receiver.layer, 1);
    vec3 t = map_axis(receiver.layer, 2);
    float facing = max(abs(dot(receiver.normal, t)) / length(t), 0.1);
    vec2 away = vec2(dot(receiver.normal, u) / dot(u, u),
                     dot(receiver.normal, v) / dot(v, v));
    return abs(away) * length(t) / facing;
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
