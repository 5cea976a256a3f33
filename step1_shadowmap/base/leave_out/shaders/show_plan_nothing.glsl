// --show plan with --shadows off, and where no visible receiver is in a map.
// needs: Receiver, scale_color
// offers: show

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    float brightness = dot(shaded, vec3(0.3, 0.5, 0.2));
    return (0.2 + 1.6 * brightness) * scale_color(0.0);
}
