#include <algorithm> // max
#include <cfloat>    // FLT_MIN
#include <cmath>     // nextafter

#include "tests/oracle/stage.h"

// Within one unit in the last place: some compilers fuse or reorder. Squares
// under FLT_MIN may be flushed to 0.
static bool is_square(float m1, float m2)
{
    float square = m1 * m1;
    float below = std::nextafter(square, -1.0f);
    float above = std::nextafter(square, 2.0f * square + 1.0f);
    return (below <= m2 && m2 <= above) || std::abs(m2 - square) <= FLT_MIN;
}

void check_moments(const Run &run, int layer, Report &report)
{
    Picture moments = load_map(run, layer);
    size_t wrong = 0;
    double worst = 0;
    for (int y = 0; y < moments.height; y++)
        for (int x = 0; x < moments.width; x++) {
            float m1 = moments.at(x, y, 0), m2 = moments.at(x, y, 1);
            wrong += is_square(m1, m2) ? 0 : 1;
            worst = std::max(worst, std::abs(double(m2) - double(m1) * m1));
        }
    report.line(wrong == 0, "stage moments: M2 is M1 squared",
                "%zu texels off by more than an ulp, worst |M2 - M1^2| %.3g",
                wrong, worst);
}
