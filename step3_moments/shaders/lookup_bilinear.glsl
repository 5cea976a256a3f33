// The moments where a point of the picture is in the map: between texels the
// weighted mean of 2 x 2, which is what the texture unit makes. Outside is far
// depth.
// needs: Receiver
// offers: moments_at, shadow_map

uniform sampler2DArray shadow_map;  // red, green: moments M1, M2 of the depth

vec2 moments_at(Receiver receiver)
{
    vec3 place = vec3(receiver.uv, float(receiver.layer));
    return textureLod(shadow_map, place, 0.0).rg;
}
