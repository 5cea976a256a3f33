// The moments where a point of the picture is in the map, between texels.

uniform sampler2DArray shadow_map;  // red, green: moments M1, M2 of the depth

vec2 moments_at(Receiver receiver)
{
    return texture(shadow_map, vec3(receiver.uv, float(receiver.layer))).rg;
}
