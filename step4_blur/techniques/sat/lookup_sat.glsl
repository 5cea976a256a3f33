// --sat: the blur's box, at the receiver itself and not at texel centres.
// needs: Receiver, shadow_map, box_mean
// offers: moments_at

uniform float box_width;  // texels

vec2 moments_at(Receiver receiver)
{
    vec2 size = vec2(textureSize(shadow_map, 0).xy);
    return box_mean(receiver.uv * size, receiver.layer, box_width);
}
