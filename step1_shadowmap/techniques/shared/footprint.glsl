// How far apart neighbouring pixels are in the map.
// needs: Receiver, map_from_relative, relative_position, to_right, to_above
// offers: footprint

// How u and v change from this pixel to the next ones: du/dx, dv/dx, du/dy,
// dv/dy. From the position, not from u and v: a neighbour may lie in another
// layer. u and v are quotients by w, which is 1 for a parallel light.
vec4 footprint(Receiver receiver)
{
    mat4 m = map_from_relative[receiver.layer];
    float w = (m * vec4(relative_position, 1.0)).w;
    vec4 right = m * vec4(to_right, 0.0);
    vec4 above = m * vec4(to_above, 0.0);
    return vec4(right.xy - receiver.uv * right.w,
                above.xy - receiver.uv * above.w) / w;
}
