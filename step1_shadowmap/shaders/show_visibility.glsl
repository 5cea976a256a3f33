// --show visibility

vec3 show(vec3 shaded, float lit)
{
    return vec3(lit);
}
