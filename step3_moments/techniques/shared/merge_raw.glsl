// --moments raw: a texel holds M1 = E[x] and M2 = E[x^2] of the depths x in it.
// Means of means: the moments of many texels are the weighted means of theirs.
// needs: nothing
// offers: Merge, moments_of, variance_of, merge_two, merge_about, merge_add,
//     merge_end, merge_sums, merge_add_sums, far_moments

const vec2 far_moments = vec2(1.0);  // of nothing but far depth

// Of a texel whose depths have a variance: in [0, 1] E[x^2] is at most E[x].
vec2 moments_of(float depth, float variance)
{
    return vec2(depth, min(depth * depth + variance, depth));
}

float variance_of(vec2 moments)
{
    return moments.y - moments.x * moments.x;
}

// Merges two texels with weights 1 - part and part.
vec2 merge_two(vec2 one, vec2 other, float part)
{
    return mix(one, other, part);
}

// A weighted mean, tap by tap. merge_central.glsl needs to know first which
// moments have the largest weight.
struct Merge {
    vec2 sum;
};

Merge merge_about(vec2 heaviest)
{
    return Merge(vec2(0.0));
}

void merge_add(inout Merge merge, float weight, vec2 moments)
{
    merge.sum += weight * moments;
}

// `weights` is the sum of them.
vec2 merge_end(Merge merge, float weights)
{
    return merge.sum / weights;
}

// What has been added so far, to be added to others.
vec2 merge_sums(Merge merge)
{
    return merge.sum;
}

void merge_add_sums(inout Merge merge, vec2 sums)
{
    merge.sum += sums;
}
