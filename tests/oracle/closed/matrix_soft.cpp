#include <algorithm> // max, min
#include <cmath>     // cos, floor, pow, sqrt

#include "tests/oracle/closed/matrix.h"

// A wider border by a texel makes the others larger, so that the search needs
// up to some texels less: the program takes the least number that is enough.
static constexpr double SLACK = 8;

// Texels of the map between the outermost of two rays to the far plane that
// see the light's sides past one point of the near plane.
static double widest_search(const Run &run, const MapView &view)
{
    glm::dvec3 across =
        glm::dvec3(view.rows[0]) - 0.5 * glm::dvec3(view.rows[3]);
    double texels = run.settings.light_size * glm::length(across) * view.width;
    if (view.parallel())
        return texels * (view.far - view.near);
    // A small circle c off the axis is an ellipse with axes 1 / cos(c) and
    // 1 / cos(c)^2 as large: the mean, in the furthest corner of the view.
    double cosine =
        view.lamp == Lamp::SPOT ? std::cos(view.cone) : std::sqrt(1 / 3.0);
    return texels * std::pow(cosine, -1.5) * (1 / view.near - 1 / view.far);
}

void check_soft_border(const Run &run, Report &report)
{
    const Settings &settings = run.settings;
    const MapView &first = run.views[0];
    double side = std::min(first.width, first.height), widest = 0;
    for (const MapView &view : run.views)
        widest = std::max(widest, widest_search(run, view));
    double disc = std::max(4.0 * settings.downsample,
                           std::min(widest, std::floor(side / 8)));
    double blur = (settings.radius + 1) * settings.downsample;
    double least = std::max(2 * (disc + blur), std::floor(side / 16));
    least = std::min(least, std::floor((side - 1) / 2));
    report.line(first.border >= least && first.border <= least + SLACK,
                "the border is the light's size wide",
                "%g texels, at least %.4g; the widest search %.4g",
                first.border, least, widest);
}
