// Light bleeds where the bound is loose; what is left of it below A is cut off
// and the rest stretched. Lauritzen, GPU Gems 3, chapter 8.
// needs: from chebyshev.c:
//     const float bleed_reduction;  A, in [0, 1)
// offers: reduce_bleeding

float reduce_bleeding(float p_max)
{
    return clamp((p_max - bleed_reduction) / (1.0 - bleed_reduction), 0.0,
                 1.0);
}
