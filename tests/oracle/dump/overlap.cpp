#include "tests/oracle/dump/overlap.h"

#include <algorithm> // max
#include <cmath>     // abs, round

static constexpr double ULP = 0x1p-23; // of 1.0f
static constexpr double MOST_OFF = 0.001;

// Where the world's origin is in a view: texels along u and v, and depth.
static glm::dvec3 origin_in(const Run &run, size_t layer)
{
    const MapView &view = run.views[layer];
    glm::dvec3 place;
    for (int axis = 0; axis < 3; axis++)
        place[axis] = view.rows[size_t(axis)].w -
                      glm::dot(glm::dvec3(view.rows[size_t(axis)]), run.origin);
    return place * glm::dvec3(view.width, view.height, 1);
}

static bool holds_depth(double depth)
{
    return depth > 0 && depth < 1;
}

static void compare_layer(const Run &run, const Run &other, size_t layer,
                          Report &report)
{
    glm::dvec3 moved = origin_in(other, layer) - origin_in(run, layer);
    int dx = int(std::round(moved.x)), dy = int(std::round(moved.y));
    std::string name = "overlap of view " + std::to_string(layer);
    report.line(std::abs(moved.x - dx) < 1e-6 && std::abs(moved.y - dy) < 1e-6,
                name + ": whole texels", "by %.9g and %.9g", moved.x, moved.y);
    Picture one = load_map(run, int(layer)), two = load_map(other, int(layer));
    size_t both = 0, off = 0;
    double worst = 0;
    for (int y = 0; y < one.height; y++)
        for (int x = 0; x < one.width; x++) {
            if (!two.holds(x + dx, y + dy))
                continue;
            double a = one.at(x, y), b = two.at(x + dx, y + dy);
            if (!holds_depth(a) || !holds_depth(b))
                continue;
            double difference = std::abs(b - a - moved.z);
            both++;
            off += difference <= 4 * ULP ? 0 : 1;
            worst = std::max(worst, difference);
        }
    report.line(both > 0 && double(off) <= MOST_OFF * double(both),
                name + ": the same depths",
                "%zu of %zu texels off by more than 4 ulp, worst %.3g", off,
                both, worst);
}

void check_overlap(const Run &run, const Run &other, Report &report)
{
    if (run.views.size() != other.views.size() || !run.views[0].parallel())
        throw BadInput("overlap is for the same splits of a parallel light");
    for (size_t layer = 0; layer < run.views.size(); layer++)
        compare_layer(run, other, layer, report);
}
