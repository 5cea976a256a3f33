// --anisotropy: taps side by side along the pixel's longer axis, each as wide
// as the shorter one. One level for the longer axis would blur across it too.
// needs: last_level, Receiver, shadow_map, Ellipse, pixel_ellipse, Merge,
//     moments_at_level, merge_about, merge_add, merge_end
// offers: moments_at

uniform int anisotropy;     // most taps
uniform float free_texels;  // around a receiver, in which all have to stay

// How much closer together the outermost taps, so many texels from the middle,
// have to be. A level's lookup reads 2.5 2^level - 1.5 texels to each side, as
// far as the border of a point light's face would let it on its own.
float drawn_together(float outermost, float level)
{
    float coarse = ceil(min(level, float(last_level)));
    float room = max(free_texels - (2.5 * exp2(coarse) - 1.5), 0.0);
    return min(1.0, room / max(outermost, 1e-30));
}

vec2 moments_at(Receiver receiver)
{
    ivec2 texels = textureSize(shadow_map, 0).xy;
    Ellipse pixel = pixel_ellipse(receiver, texels);
    float ratio = pixel.longer / max(pixel.shorter, 1.0);
    int taps = int(clamp(ratio, 1.0, float(anisotropy)) + 0.5);
    float tap_length = pixel.longer / float(taps);
    float level = log2(max(max(pixel.shorter, tap_length), 1.0));
    float outermost = 0.5 * float(taps - 1) * tap_length;
    float apart = tap_length * drawn_together(outermost, level);
    vec2 tap_step = pixel.direction * apart / vec2(texels);
    Merge merge;
    for (int i = 0; i < taps; i++) {
        float steps = float(i) - 0.5 * float(taps - 1);
        vec2 tap = moments_at_level(receiver.uv + steps * tap_step,
                                    receiver.layer, level);
        if (i == 0) {
            merge = merge_about(tap);
        }
        merge_add(merge, 1.0, tap);
    }
    return merge_end(merge, float(taps));
}
