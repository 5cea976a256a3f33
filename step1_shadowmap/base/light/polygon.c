#include "step1_shadowmap/base/light/polygon.h"

#include <string.h> // memcpy

#include "step1_shadowmap/base/scene/dvec.h" // dvec_copy, dvec_dot

int polygon_clip(double polygon[][3], int count, const double normal[3],
                 double limit)
{
    double result[POLYGON_MAX_CORNERS][3];
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const double *a = polygon[i];
        const double *b = polygon[(i + 1) % count];
        double inside_a = limit - dvec_dot(normal, a);
        double inside_b = limit - dvec_dot(normal, b);
        if (inside_a >= 0) {
            dvec_copy(a, result[kept++]);
        }
        if ((inside_a >= 0) != (inside_b >= 0)) {
            double part = inside_a / (inside_a - inside_b);
            for (int k = 0; k < 3; k++) {
                result[kept][k] = a[k] + part * (b[k] - a[k]);
            }
            kept++;
        }
    }
    memcpy(polygon, result, sizeof result[0] * (size_t)kept);
    return kept;
}
