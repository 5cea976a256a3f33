// --min-variance auto, of raw moments however they were filtered: as the
// lesson's visibility.glsl. proof.md shows that p is then never below the lit
// share.
// needs: Receiver; from guard_settings.c:
//     const vec2 chain_mean;      the part of M1, and a constant
//     const vec2 chain_variance;  the part of M2, and a constant
// offers: guarded

// The mean and the variance of the depths, at most.
vec2 guarded(vec2 moments, Receiver receiver)
{
    float M1 = moments.x;
    float M2 = moments.y;
    float variance = max(M2 - M1 * M1, 0.0);
    return vec2(M1 + (chain_mean.x * M1 + chain_mean.y),
                variance + (chain_variance.x * M2 + chain_variance.y));
}
