// Three-vectors in double precision. cglm has only single; positions and
// matrices are made in double so that a world a million units from the
// origin looks the same (they are rounded once, when handed to OpenGL).
#ifndef BASE_DVEC_H
#define BASE_DVEC_H

#include <math.h> // sqrt

#define RADIANS(degrees) ((degrees)*0.017453292519943295)

static inline double dvec_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void dvec_copy(const double a[3], double result[3])
{
    for (int i = 0; i < 3; i++) {
        result[i] = a[i];
    }
}

static inline void dvec_subtract(const double a[3], const double b[3],
                                 double result[3])
{
    for (int i = 0; i < 3; i++) {
        result[i] = a[i] - b[i];
    }
}

static inline void dvec_cross(const double a[3], const double b[3],
                              double result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void dvec_scale(double a[3], double factor)
{
    for (int i = 0; i < 3; i++) {
        a[i] *= factor;
    }
}

// The zero vector stays as it is.
static inline void dvec_normalize(double a[3])
{
    double length = sqrt(dvec_dot(a, a));
    if (length > 0) {
        dvec_scale(a, 1 / length);
    }
}

// The axes of a viewer that looks along `forward` (unit): right and up, both
// unit. Where forward is parallel to the hint, the x axis replaces the hint.
static inline void dvec_frame(const double forward[3], const double hint[3],
                              double right[3], double up[3])
{
    const double x_axis[3] = {1, 0, 0};
    dvec_cross(forward, hint, right);
    if (dvec_dot(right, right) < 1e-12 * dvec_dot(hint, hint)) {
        dvec_cross(forward, x_axis, right);
    }
    dvec_normalize(right);
    dvec_cross(right, forward, up);
}

#endif
