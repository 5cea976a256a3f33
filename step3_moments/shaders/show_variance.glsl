// --show variance: of the texels that each point looks up, on a logarithmic
// scale from 1e-9 (what rounding leaves of none) to 1e-1.
// needs: Receiver, moments_at, scale_color
// offers: show

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    vec2 moments = moments_at(receiver);
    float variance = max(moments.y - moments.x * moments.x, 1e-9);
    float decades = log(variance) / log(10.0);
    return scale_color(clamp((decades + 9.0) / 8.0, 0.0, 1.0));
}
