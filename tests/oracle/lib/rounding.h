// The error of 32-bit arithmetic. Source of the bounds: N. Higham, Accuracy
// and Stability of Numerical Algorithms, chapters 2 and 3.
#ifndef ORACLE_ROUNDING_H
#define ORACLE_ROUNDING_H

// Unit roundoff of a 32-bit float: one operation is off by at most this share
// of its result.
constexpr double UNIT_ROUNDOFF = 0x1p-24;

// The share by which a result of n rounded operations on numbers of one sign
// can be off: n u / (1 - n u).
constexpr double rounding_share(int n)
{
    return n * UNIT_ROUNDOFF / (1 - n * UNIT_ROUNDOFF);
}

// A rasteriser snaps vertices to 1/256 pixel (OpenGL asks for 4 bits at least,
// llvmpipe and GPUs have 8), so a vertex moves by up to 1/512 along each axis
// and an edge by up to sqrt(2)/512 = 1/362. In pixels, or texels of a map.
constexpr double SUBPIXEL = 1.0 / 256;

#endif
