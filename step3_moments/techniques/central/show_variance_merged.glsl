// In place of show_variance.glsl, for raw and central moments alike.
// needs: Receiver, variance_of, moments_at, scale_color
// offers: show

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    float variance = max(variance_of(moments_at(receiver)), 1e-9);
    float decades = log(variance) / log(10.0);
    return scale_color(clamp((decades + 9.0) / 8.0, 0.0, 1.0));
}
