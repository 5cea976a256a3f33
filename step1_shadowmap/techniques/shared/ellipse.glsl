// What a pixel, taken as a disc, covers of the map: an ellipse. Lengths of its
// axes in texels.
// needs: Receiver, footprint
// offers: Ellipse, pixel_ellipse

struct Ellipse {
    vec2 direction;  // of the longer axis, unit
    float longer;
    float shorter;
};

// The columns of J are the steps to the next pixels. The axes' lengths are the
// roots of the eigenvalues of J J^T = (a b; b c), and their product is |det J|.
Ellipse pixel_ellipse(Receiver receiver, ivec2 map_size)
{
    vec4 j = footprint(receiver) * vec2(map_size).xyxy;
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
