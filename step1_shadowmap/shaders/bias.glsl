// How much nearer to the light a receiver is taken to be, so that a surface
// does not shadow itself: a texel holds one depth for a whole patch of it.
// needs: Receiver, depth_slope
// offers: comparison_bias

uniform float bias;        // of the depth range
uniform float slope_bias;  // of the depth change across half the kernel

// For a comparison with kernel x kernel texels of a map of map_size texels:
// along each axis the furthest texel centre is at most kernel / 2 texels from
// the receiver; half a texel more is margin.
float comparison_bias(Receiver receiver, int kernel, vec2 map_size)
{
    vec2 per_texel = abs(depth_slope(receiver.relative_position,
                                     receiver.normal, receiver.layer)) /
                     map_size;
    float half_kernel = 0.5 * float(kernel + 1);
    return bias + slope_bias * half_kernel * (per_texel.x + per_texel.y);
}
