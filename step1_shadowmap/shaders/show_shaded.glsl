// --show shaded

vec3 show(vec3 shaded, float lit)
{
    return shaded;
}
