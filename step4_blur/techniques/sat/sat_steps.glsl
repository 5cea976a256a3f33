// A summed-area table begins with whole numbers: 32-bit integers add without
// rounding, where sums of floats over a map lose the bits that the difference
// of two sums needs. Worst error of the variance, measured for a box of 7 x 7
// in a map of 1024^2: floats 4.1e-3, floats of depth - 0.5 2.5e-4, these 1.2e-7.
// What is summed is nearness, 1 - M, which is 0 at far
// depth: so what lies outside the map adds nothing.
// needs: nothing
// offers: nearness_steps

uniform uint steps;  // 1.0 in whole numbers, a power of two

uvec2 nearness_steps(vec2 moments)
{
    vec2 nearness = 1.0 - moments;
    return uvec2(clamp(nearness, 0.0, 1.0) * float(steps) + 0.5);
}
