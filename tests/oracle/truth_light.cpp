#include <cmath>  // abs
#include <memory> // shared_ptr

#include "tests/oracle/strata.h"
#include "tests/oracle/truth.h"

static glm::dvec3 lifted(const TruthScene &scene, const Surface &surface)
{
    return surface.point + scene.lift * surface.normal;
}

Truth hard_truth(const TruthScene &scene)
{
    auto at = [&scene](const Pixel &pixel) -> TruthValue {
        glm::dvec3 light = to_light(scene.view(pixel.receiver));
        return {scene.lit(lifted(scene, pixel.surface), light) ? 1.0 : 0.0};
    };
    return {"hard", at};
}

// Two directions of unit length across the light's, and across each other.
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
        glm::dvec3 light = to_light(scene.view(pixel.receiver)), a, b;
        span(light, a, b);
        const Pattern &pattern = strata->at(pixel.x, pixel.y);
        double lit = 0;
        for (const glm::dvec2 &p : pattern)
            lit += scene.lit(lifted(scene, pixel.surface),
                             light + p.x * a + p.y * b)
                       ? 1
                       : 0;
        return {lit / double(pattern.size())};
    };
    return {"area", at};
}
