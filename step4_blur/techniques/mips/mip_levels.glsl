// Looking up a mip-map chain at a level of one's own choice. (The level that
// texture() chooses is another one on every GPU.)
// needs: merge_two, moments_between
// offers: moments_at_level, last_level

uniform int last_level;  // of the chain; level 0 is the finest

// Trilinear, between the two nearest levels. The weights of the levels are
// applied by hand: GPUs keep only 8 bits of them.
vec2 moments_at_level(vec2 uv, int layer, float level)
{
    float last = float(last_level);
    float wanted = clamp(level, 0.0, last);
    float fine = floor(wanted);
    return merge_two(moments_between(uv, layer, fine),
                     moments_between(uv, layer, min(fine + 1.0, last)),
                     wanted - fine);
}
