// Light bleeds where the bound is loose. So visibility up to a constant A,
// --bleed-reduction, becomes 0, and the rest is stretched to [0, 1]. Lauritzen,
// GPU Gems 3, chapter 8.
// needs: from chebyshev.c:
//     const float bleed_reduction;  A, in [0, 1)
// offers: reduce_bleeding

float reduce_bleeding(float p_max)
{
    return clamp((p_max - bleed_reduction) / (1.0 - bleed_reduction), 0.0,
                 1.0);
}
