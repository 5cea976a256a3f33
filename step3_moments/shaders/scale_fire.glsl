// From 0, near black, to 1, yellow: for values on a logarithmic scale.
// needs: nothing
// offers: scale_color

vec3 scale_color(float part)
{
    vec3 low = mix(vec3(0.02, 0.02, 0.10), vec3(0.45, 0.03, 0.30),
                   clamp(2.0 * part, 0.0, 1.0));
    return mix(low, vec3(1.0, 0.85, 0.20), clamp(2.0 * part - 1.0, 0.0, 1.0));
}
