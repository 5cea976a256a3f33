// --moments central: a texel holds the mean and the variance of the depths in
// it, so that no lookup has to take two large numbers from each other.
// needs: nothing
// offers: Merge, moments_of, variance_of, merge_two, merge_about, merge_add,
//     merge_end, merge_sums, merge_add_sums, far_moments

const vec2 far_moments = vec2(1.0, 0.0);  // of nothing but far depth

// Of a texel whose depths have a variance: in [0, 1] E[x^2] is at most E[x].
vec2 moments_of(float depth, float variance)
{
    return vec2(depth, min(variance, depth - depth * depth));
}

float variance_of(vec2 moments)
{
    return moments.y;
}

// Merges two texels with weights 1 - part and part, whose means are d apart: the
// variance is the weighted mean of theirs plus part (1 - part) d^2. The mean is
// taken from the larger part, so that a small one that is far away adds no
// rounding of its size.
vec2 merge_two(vec2 one, vec2 other, float part)
{
    float rest = 1.0 - part;
    float apart = other.x - one.x;
    float mean = part < 0.5 ? one.x + part * apart : other.x - rest * apart;
    return vec2(mean, rest * one.y + part * other.y +
                          part * rest * apart * apart);
}

// The mean and the variance of many texels, with weights w that add up to 1,
// means m and variances v, relative to any depth c:
//     mean = c + s,  s = sum w (m - c)
//     variance = sum w (v + (m - c)^2) - s^2
// With c the mean of largest weight the last term is never much larger than
// what is left: nothing cancels, however close the depths are. With c = 0 this
// would be M2 - M1^2 again.
struct Merge {
    float about;   // c
    float shift;   // sum w (m - c)
    float square;  // sum w (v + (m - c)^2)
};

// Begins with no texel, relative to the mean of the one of largest weight.
Merge merge_about(vec2 heaviest)
{
    return Merge(heaviest.x, 0.0, 0.0);
}

void merge_add(inout Merge merge, float weight, vec2 moments)
{
    float from = moments.x - merge.about;
    merge.shift += weight * from;
    merge.square += weight * (moments.y + from * from);
}

// `weights` is the sum of them.
vec2 merge_end(Merge merge, float weights)
{
    float shift = merge.shift / weights;
    float variance = merge.square / weights - shift * shift;
    return vec2(merge.about + shift, max(variance, 0.0));
}

// What has been added so far, to be added to others relative to the same depth.
vec2 merge_sums(Merge merge)
{
    return vec2(merge.shift, merge.square);
}

void merge_add_sums(inout Merge merge, vec2 sums)
{
    merge.shift += sums.x;
    merge.square += sums.y;
}
