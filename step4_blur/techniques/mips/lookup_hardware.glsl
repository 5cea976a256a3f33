// --sampler hardware: the texture unit chooses the level, blends the levels and
// takes its own taps. How, differs from one GPU to the next, but it is handed
// the same derivatives.
// needs: Receiver, footprint
// offers: moments_at, shadow_map

uniform sampler2DArray shadow_map;  // red, green: moments M1, M2 of the depth

vec2 moments_at(Receiver receiver)
{
    vec4 steps = footprint(receiver);
    vec3 where = vec3(receiver.uv, float(receiver.layer));
    return textureGrad(shadow_map, where, steps.xy, steps.zw).rg;
}
