#include "tests/oracle/filters/poisson_disc.h"

#include <cmath> // acos, cos, sin

static constexpr double POINTS[POISSON_TAPS][2] = {
    {0.0043, 0.0175},  {-0.1701, -0.2224}, {0.2233, -0.1762},
    {-0.2932, 0.1247}, {-0.0104, 0.3231},  {0.3193, 0.1560},
    {0.1434, -0.4974}, {-0.5436, -0.0716}, {-0.1777, -0.5274},
    {0.3302, 0.4703},  {0.5783, 0.0208},   {0.4759, -0.3331},
    {-0.3617, 0.4560}, {-0.4623, -0.3626}, {-0.0408, 0.6193},
    {-0.6032, 0.2327}, {-0.0734, -0.8306}, {0.4835, -0.6847},
    {0.7307, 0.4153},  {-0.3919, -0.7465}, {-0.8113, -0.2540},
    {0.2243, -0.8202}, {0.8441, -0.1986},  {-0.6591, -0.5639},
    {-0.8698, 0.1011}, {0.7282, -0.4951},  {0.2432, 0.8496},
    {-0.4568, 0.7594}, {-0.7371, 0.4976},  {0.8796, 0.1317},
    {0.5696, 0.7056},  {-0.1155, 0.9037},
};

// In sixteenths of a turn, for 4 x 4 pixels.
static constexpr int TURNS[4][4] = {
    {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

std::array<glm::dvec2, POISSON_TAPS> poisson_taps(int x, int y)
{
    double angle = TURNS[y % 4][x % 4] * std::acos(-1.0) / 8;
    double c = std::cos(angle), s = std::sin(angle);
    std::array<glm::dvec2, POISSON_TAPS> taps;
    for (size_t i = 0; i < taps.size(); i++)
        taps[i] = {c * POINTS[i][0] - s * POINTS[i][1],
                   s * POINTS[i][0] + c * POINTS[i][1]};
    return taps;
}
