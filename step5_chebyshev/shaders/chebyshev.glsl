// Step 5: Donnelly, Lauritzen, Variance shadow maps, I3D 2006.
// needs: nothing
// offers: chebyshev

// The largest part of the filter's depths X that can be at or behind t:
// P(X >= t) <= variance / (variance + (t - mean)^2) where t > mean (Cantelli's
// one-tailed form of Chebyshev's inequality).
float chebyshev(float mean, float variance, float t)
{
    float behind = t - mean;
    float p_max = variance / (variance + behind * behind);
    return behind > 0.0 ? p_max : 1.0;
}
