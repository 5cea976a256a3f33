// Looking up a mip-map chain at a level of one's own choice. (The level that
// texture() chooses is another one on every GPU.)

uniform sampler2DArray shadow_map;  // red, green: moments M1, M2 of the depth
uniform int last_level;             // of its chain; level 0 is the finest

// Trilinear, between the two nearest levels. The weights of the levels are
// applied by hand: GPUs keep only 8 bits of them.
vec2 moments_at_level(vec2 uv, int layer, float level)
{
    float last = float(last_level);
    float wanted = clamp(level, 0.0, last);
    float fine = floor(wanted);
    vec3 where = vec3(uv, float(layer));
    return mix(textureLod(shadow_map, where, fine).rg,
               textureLod(shadow_map, where, min(fine + 1.0, last)).rg,
               wanted - fine);
}

// What a pixel, taken as a disc, covers of the map: an ellipse. Lengths of its
// axes in texels of level 0.
struct Ellipse {
    vec2 direction;  // of the longer axis, unit
    float longer;
    float shorter;
};

// The columns of J are the steps to the next pixels. The axes' lengths are the
// roots of the eigenvalues of J J^T = (a b; b c), and their product is |det J|.
Ellipse pixel_ellipse(Receiver receiver)
{
    vec4 j = footprint(receiver) * vec2(textureSize(shadow_map, 0)).xyxy;
    float a = j.x * j.x + j.z * j.z;
    float b = j.x * j.y + j.z * j.w;
    float c = j.y * j.y + j.w * j.w;
    float half_difference = 0.5 * (a - c);
    float root = length(vec2(half_difference, b));
    float longer = sqrt(0.5 * (a + c) + root);
    float area = abs(j.x * j.w - j.y * j.z);
    vec2 axis = half_difference > 0.0 ? vec2(root + half_difference, b)
                                      : vec2(b, root - half_difference);
    // A circle has no longer axis, a point no shorter one.
    return Ellipse(axis / max(length(axis), 1e-30), longer,
                   min(area / max(longer, 1e-30), longer));
}
