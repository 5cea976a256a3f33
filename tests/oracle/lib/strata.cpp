#include "tests/oracle/lib/strata.h"

#include <cmath> // sqrt, sin, cos
#include <glm/gtc/constants.hpp>
#include <random> // mt19937

#include "tests/oracle/lib/verdict.h" // BadInput

static constexpr int PATTERNS = 256;

Strata::Strata(double rays) : patterns_(PATTERNS)
{
    int m = int(std::lround(std::sqrt(rays)));
    if (!(rays >= 4 && rays <= 1e6) || double(m) * m != rays)
        throw BadInput("rays: the square of a whole number, 4 to 1000000");
    std::mt19937 random(1); // std's distributions differ between libraries
    auto uniform = [&] { return (random() + 0.5) / 4294967296.0; };
    for (Pattern &pattern : patterns_)
        for (int j = 0; j < m; j++)
            for (int i = 0; i < m; i++) {
                double x = (i + uniform()) / m;
                pattern.push_back({x, (j + uniform()) / m});
            }
}

const Pattern &Strata::at(int x, int y) const
{
    unsigned hash = unsigned(x) * 73856093u ^ unsigned(y) * 19349663u;
    return patterns_[(hash ^ hash >> 13) % PATTERNS];
}

glm::dvec2 disc_point(const glm::dvec2 &square)
{
    double a = 2 * square.x - 1, b = 2 * square.y - 1;
    double quarter = glm::pi<double>() / 4;
    bool wide = std::abs(a) > std::abs(b);
    double radius = wide ? a : b;
    if (radius == 0)
        return {0, 0};
    double angle = wide ? quarter * b / a : quarter * (2 - a / b);
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

double strata_deviation(double rays, double crossed)
{
    return std::sqrt(crossed * std::sqrt(rays)) / (2 * rays);
}
