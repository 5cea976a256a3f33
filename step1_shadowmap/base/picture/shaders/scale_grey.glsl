// From 0, black, to 1, white.

vec3 scale_color(float part)
{
    return vec3(part);
}
