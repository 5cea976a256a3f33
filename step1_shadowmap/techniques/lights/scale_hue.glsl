// Eight hues, one for each layer of a map; part is layer / 7.
// needs: nothing
// offers: scale_color

vec3 scale_color(float part)
{
    vec3 phase = vec3(0.0, 2.1, 4.2) + 5.4 * part;
    return 0.5 + 0.5 * cos(phase);
}
