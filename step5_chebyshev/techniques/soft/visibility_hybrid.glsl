// --hybrid: the moments say only how wide the penumbra is. Over its disc single
// depths are compared, as in step 2: no bound, so no light bleeds. The map has
// not been filtered, so M1 is a depth.
// needs: Disc, LEAST_DISC, Receiver, penumbra_disc, shadow_map, depth_slope,
//     comparison_bias, POISSON_TAPS, poisson_tap
// offers: visibility

// Where a caster stands on the receiver even the least disc is too wide: it
// would reach the light on the caster's other side. There it is half as wide as
// the occluder is far away.
float reach(Disc disc)
{
    return disc.texels > LEAST_DISC ? 1.0
                                    : min(0.5 * disc.gap / LEAST_DISC, 1.0);
}

float visibility(Receiver receiver)
{
    Disc disc = penumbra_disc(receiver);
    if (disc.lit) {
        return 1.0;
    }
    ivec2 size = textureSize(shadow_map, 0).xy;
    vec2 slope = depth_slope(receiver.relative_position, receiver.normal,
                             receiver.layer);
    float bias = comparison_bias(receiver, 1, vec2(size));
    mat2 uv_step = reach(disc) * disc.uv_step;
    float lit = 0.0;
    for (int i = 0; i < POISSON_TAPS; i++) {
        vec2 place = receiver.uv + uv_step * poisson_tap(i);
        ivec2 texel =
            clamp(ivec2(floor(place * vec2(size))), ivec2(0), size - 1);
        // A wide disc wants no wide bias: it is compared with the receiver's
        // own plane, at the middle of each texel.
        vec2 away = (vec2(texel) + 0.5) / vec2(size) - receiver.uv;
        float plane = receiver.depth + dot(slope, away);
        float occluder =
            texelFetch(shadow_map, ivec3(texel, receiver.layer), 0).r;
        lit += plane - bias <= occluder ? 1.0 : 0.0;
    }
    return lit / float(POISSON_TAPS);
}
