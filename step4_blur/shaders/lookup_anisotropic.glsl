// --anisotropy: taps side by side along the pixel's longer axis, each as wide
// as the shorter one. One level for the longer axis would blur across it too.

uniform int anisotropy;  // most taps

vec2 moments_at(Receiver receiver)
{
    ivec2 texels = textureSize(shadow_map, 0).xy;
    Ellipse pixel = pixel_ellipse(receiver, texels);
    float ratio = pixel.longer / max(pixel.shorter, 1.0);
    int taps = int(clamp(ratio, 1.0, float(anisotropy)) + 0.5);
    float tap_length = pixel.longer / float(taps);
    float level = log2(max(max(pixel.shorter, tap_length), 1.0));
    vec2 tap_step = pixel.direction * tap_length / vec2(texels);
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
