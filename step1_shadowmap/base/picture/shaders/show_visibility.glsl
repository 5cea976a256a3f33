// --show visibility

vec3 show(vec3 shaded, Receiver receiver, float lit)
{
    return vec3(lit);
}
