// --mips: the level whose texels are as wide as the pixel is long in the map.
// needs: Receiver, shadow_map, pixel_ellipse, moments_at_level
// offers: moments_at

vec2 moments_at(Receiver receiver)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    float level = log2(max(pixel_ellipse(receiver, size).longer, 1.0));
    return moments_at_level(receiver.uv, receiver.layer, level);
}
