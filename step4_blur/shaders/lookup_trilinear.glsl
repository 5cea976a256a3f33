// --mips: the level whose texels are as wide as the pixel is long in the map.

vec2 moments_at(Receiver receiver)
{
    float level = log2(max(pixel_ellipse(receiver).longer, 1.0));
    return moments_at_level(receiver.uv, receiver.layer, level);
}
