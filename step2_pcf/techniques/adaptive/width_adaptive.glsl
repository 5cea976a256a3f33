// --adaptive: as wide as what the pixel covers of the map, which is more the
// further away it is. Where texels are wider than pixels there is nothing to
// average but the steps of the texels themselves: 3 of them.
// needs: Receiver, shadow_map, pixel_ellipse; from pcf.c:
//     const int kernel;  texels, odd
// offers: filter_width

int filter_width(Receiver receiver)
{
    ivec2 size = textureSize(shadow_map, 0).xy;
    float texels = pixel_ellipse(receiver, size).longer;
    int radius = int(ceil(clamp(0.5 * (texels - 1.0), 1.0, 127.0)));
    return min(2 * radius + 1, kernel);
}
