// A box along each row or column, one line for each invocation, in additions
// alone: taking away what leaves the box would leave its rounding in all that
// follows.
//
// Lines are cut into blocks as long as the box. Wherever a box lies, it holds
// the first texel of exactly one block, `start`: so it is some last texels of
// the block before it and some first ones of the block that begins there. Sums
// from start downwards and upwards, each one addition from the next, make all
// the boxes around it. All of them hold that texel, and merge_about() lets each
// sum add depths minus its depth.
// (van Herk, A fast algorithm for local minimum and maximum filters on
// rectangular and octagonal kernels, 1992, has these blocks for minima.)
// needs: far_moments, Merge, merge_about, merge_sums, merge_add,
//     merge_add_sums, merge_end; from running_box.c:
//     const ivec2 sides;  texels before and after the one in the middle
// offers: blurred

layout(local_size_x = 64) in;

const int width = sides.x + 1 + sides.y;

layout(rg32f) readonly uniform image2DArray map;
layout(rg32f) writeonly uniform image2DArray blurred;
uniform int layer;
uniform ivec2 axis;   // (1, 0) along u, (0, 1) along v
uniform ivec2 lines;  // from the first one up to, not including, another
uniform ivec2 middles;  // from the first block's start to where boxes' middles
                        // end

// What lies along one line.
int line = lines.x + int(gl_GlobalInvocationID.x);
int last;  // texel of it

vec2 before[width];  // of a block's boxes, what lies before its start

ivec3 place(int along)
{
    return ivec3(along * axis + line * axis.yx, layer);
}

bool inside(int along)
{
    return uint(along) <= uint(last);
}

vec2 line_texel(int along)
{
    return inside(along) ? imageLoad(map, place(along)).rg : far_moments;
}

// Keeps, for the box that begins i before start, the sum of all before start.
void sum_before(int start, vec2 first)
{
    Merge sum = merge_about(first);
    before[0] = merge_sums(sum);
    for (int i = 1; i < width; i++) {
        merge_add(sum, 1.0, line_texel(start - i));
        before[i] = merge_sums(sum);
    }
}

// Adds all from start to the end of each box, which is i behind start.
void sum_after(int start, vec2 first)
{
    Merge sum = merge_about(first);
    for (int i = 0; i < width; i++) {
        int middle = start + i - sides.y;
        merge_add(sum, 1.0, line_texel(start + i));
        if (inside(middle)) {
            Merge box = sum;
            merge_add_sums(box, before[width - 1 - i]);
            vec2 moments = merge_end(box, float(width));
            imageStore(blurred, place(middle), moments.xyxy);
        }
    }
}

void main()
{
    ivec2 size = imageSize(blurred).xy;
    last = (axis.x == 1 ? size.x : size.y) - 1;
    if (line >= lines.y) {
        return;
    }
    int start = middles.x;
    for (; start - sides.y < middles.y; start += width) {
        vec2 first = line_texel(start);
        sum_before(start, first);
        sum_after(start, first);
    }
}
