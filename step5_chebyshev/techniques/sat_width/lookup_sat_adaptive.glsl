// --sat-width adaptive: a box of as many texels as a texel is half pixels wide
// on the screen. Where the camera is close a texel covers many pixels and its
// square shows: there the box grows, up to the radius that was asked for. Where
// a texel is half a pixel or less there is nothing to hide, and one is enough.
// needs: Receiver, footprint, shadow_map, box_mean
// offers: moments_at

uniform float box_width;  // texels, at most

// A pixel covers |det J| texels of the map, and a texel as many pixels as that
// is part of 1. The square root is a width: a square box cannot follow the
// direction in which a texel is stretched.
float adaptive_width(Receiver receiver)
{
    vec4 j = footprint(receiver) * vec2(textureSize(shadow_map, 0)).xyxy;
    float texels = abs(j.x * j.w - j.y * j.z);
    return clamp(2.0 * inversesqrt(max(texels, 1e-12)), 1.0, box_width);
}

vec2 moments_at(Receiver receiver)
{
    vec2 size = vec2(textureSize(shadow_map, 0).xy);
    return box_mean(receiver.uv * size, receiver.layer,
                    adaptive_width(receiver));
}
