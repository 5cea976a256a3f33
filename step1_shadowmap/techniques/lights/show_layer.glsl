// --show layer: which layer of the map each point looks up, as a hue over the
// shaded picture; grey where the map does not reach.
// needs: Receiver, inside_map, scale_color
// offers: show

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    float brightness = dot(shaded, vec3(0.3, 0.5, 0.2));
    vec3 hue = inside_map(receiver)
                   ? scale_color(float(receiver.layer) / 7.0) : vec3(0.6);
    return 1.6 * brightness * hue;
}
