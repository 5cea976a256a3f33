// From 0, black, to 1, white.
// needs: nothing
// offers: scale_color

vec3 scale_color(float part)
{
    return vec3(part);
}
