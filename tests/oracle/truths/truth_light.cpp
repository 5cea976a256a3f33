#include <cmath>  // abs, INFINITY
#include <memory> // shared_ptr

#include "tests/oracle/dump/light.h" // towards_light
#include "tests/oracle/lib/strata.h"
#include "tests/oracle/truths/truth.h"

Truth hard_truth(const TruthScene &scene)
{
    auto at = [&scene](const Pixel &pixel) -> TruthValue {
        const MapView &view = scene.view(pixel.receiver);
        glm::dvec3 point = scene.lifted(pixel.surface);
        return {scene.lit(view, point) ? 1.0 : 0.0};
    };
    return {"hard", at};
}

// Two directions of unit length across a third, and across each other.
static void span(const glm::dvec3 &light, glm::dvec3 &a, glm::dvec3 &b)
{
    glm::dvec3 other(0);
    other[std::abs(light.x) < 0.5 ? 0 : 1] = 1;
    a = glm::normalize(glm::cross(light, other));
    b = glm::cross(light, a);
}

Truth area_truth(const TruthScene &scene, double rays, double size)
{
    auto strata = std::make_shared<Strata>(rays);
    for (Pattern &pattern : strata->all())
        for (glm::dvec2 &point : pattern)
            point = size / 2 * disc_point(point);
    auto at = [&scene, strata](const Pixel &pixel) -> TruthValue {
        const MapView &view = scene.view(pixel.receiver);
        glm::dvec3 point = scene.lifted(pixel.surface), a, b;
        glm::dvec3 light = towards_light(view, point);
        span(glm::normalize(light), a, b);
        // A parallel light is a disc at a distance of 1 that goes on for ever.
        double end = view.parallel() ? INFINITY : 1;
        const Pattern &pattern = strata->at(pixel.x, pixel.y);
        double lit = 0;
        for (const glm::dvec2 &p : pattern) {
            Ray ray{point, light + p.x * a + p.y * b};
            lit += scene.rays.occluded(ray, end) ? 0 : 1;
        }
        return {lit / double(pattern.size())};
    };
    return {"area", at};
}
