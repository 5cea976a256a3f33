// --reduction smooth: the same cut with rounded ends, 3 s^2 - 2 s^3 of the
// linear form s. Penumbrae end softly, and are narrower in the middle.
// needs: from chebyshev.c:
//     const float bleed_reduction;  in [0, 1)
// offers: reduce_bleeding

float reduce_bleeding(float p_max)
{
    return smoothstep(bleed_reduction, 1.0, p_max);
}
