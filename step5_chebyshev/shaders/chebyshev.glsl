// Step 5: Donnelly, Lauritzen, Variance shadow maps, I3D 2006.

uniform float min_variance;        // of the squared depth range
uniform float min_variance_of_m2;  // of M2: what rounding M2 can hide
uniform float variance_bias;       // added to every variance, likewise

// The largest part of the filter's depths X that can be at or behind t, given
// their first two moments: P(X >= t) <= variance / (variance + (t - M1)^2)
// where t > M1 (Cantelli's one-tailed form of Chebyshev's inequality).
float chebyshev(vec2 moments, float t)
{
    float least = max(min_variance, min_variance_of_m2 * moments.y);
    float variance = max(variance_of(moments), least);
    variance = min(variance + variance_bias, 1.0);
    float behind = t - moments.x;
    float p_max = variance / (variance + behind * behind);
    return behind > 0.0 ? p_max : 1.0;
}

float visibility(Receiver receiver)
{
    return reduce_bleeding(chebyshev(moments_at(receiver), receiver.depth));
}
