// The mean over any box of the map, from a summed-area table of 1 - M1 and
// 1 - M2. Crow, Summed-area tables for texture mapping, SIGGRAPH 1984.
// needs: nothing
// offers: box_mean, shadow_map

uniform usampler2DArray shadow_map;  // red, green: the two sums
uniform uint steps;                  // 1.0 in whole numbers

// The sum of all texels left of `column` and below `row`. They go round at
// 2^32; their differences are right as long as a box's own sum is less.
uvec2 sum_before(int column, int row, int layer)
{
    ivec2 last = min(ivec2(column, row), textureSize(shadow_map, 0).xy) - 1;
    bool empty = any(lessThan(last, ivec2(0)));
    return empty ? uvec2(0u) : texelFetch(shadow_map, ivec3(last, layer), 0).rg;
}

// One axis of the box: whole texels in the middle, and what it has of the
// texel at each end.
struct Side {
    ivec4 edges;   // where the first, the middle and the last part begin, end
    vec3 weights;  // of the three parts
};

// From `low` on. Its end is counted from the first texel and not from the map's
// edge: small numbers, so that the weights add up to the width.
Side box_side(float low, float width)
{
    float within = low - floor(low);
    float end = within + width;
    int first = int(floor(low));
    int last = first + int(floor(end));
    return Side(ivec4(first, first + 1, last, last + 1),
                vec3(1.0 - within, 1.0, end - floor(end)));
}

// M1 and M2 over the box of width x width texels around `middle` (in texels;
// width 1 or more). Four corners, each between 2 x 2 texels of the table: all
// differences are taken in whole numbers, then weighted as floats.
vec2 box_mean(vec2 middle, int layer, float width)
{
    Side across = box_side(middle.x - 0.5 * width, width);
    Side up = box_side(middle.y - 0.5 * width, width);
    vec2 sum = vec2(0.0);
    uvec2 below[4];
    for (int j = 0; j < 4; j++) {
        uvec2 here[4];
        for (int i = 0; i < 4; i++) {
            here[i] = sum_before(across.edges[i], up.edges[j], layer);
        }
        for (int i = 1; j > 0 && i < 4; i++) {
            uvec2 part = here[i] - here[i - 1] - below[i] + below[i - 1];
            sum += across.weights[i - 1] * up.weights[j - 1] * vec2(part);
        }
        below = here;
    }
    return 1.0 - sum / (float(steps) * width * width);
}
