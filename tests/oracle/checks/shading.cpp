#include "tests/oracle/checks/shading.h"

#include <algorithm> // clamp, max
#include <cmath>     // abs, cos

#include "tests/oracle/dump/light.h"
#include "tests/oracle/dump/projection.h"

// A spot keeps its full brightness up to this part of its cone.
static constexpr double BRIGHT_PART = 0.8;
// Some ten roundings, and the cone's ratio of small differences.
static constexpr double TOLERANCE = 2e-5;
// Pixels at outlines show another object than their ray meets.
static constexpr double MOST_APART = 0.02;

// How much of the radiance arrives at a distance and, of a spot, off its axis.
static double arriving(const Light &light, const MapView &view,
                       const glm::dvec3 &point)
{
    if (view.parallel())
        return 1;
    glm::dvec3 towards = towards_light(view, point);
    double distance = glm::length(towards);
    double part = light.reference / distance;
    if (view.lamp == Lamp::POINT)
        return part * part;
    double cosine = -glm::dot(vec3_of(light.direction), towards) / distance;
    double edge = std::cos(light.cone);
    double bright = std::cos(BRIGHT_PART * light.cone);
    double cone = std::clamp((cosine - edge) / (bright - edge), 0.0, 1.0);
    return part * part * cone * cone;
}

static double worst_channel(const Scene &scene, const Object &object,
                            double light, const Picture &image, int x, int y)
{
    double worst = 0;
    for (int c = 0; c < 3; c++) {
        double own = object.albedo[c] * (double(scene.light.ambient[c]) +
                                         scene.light.radiance[c] * light);
        double error = std::abs(image.at(x, y, c) - own);
        worst = std::max(worst, error / std::max(1.0, own));
    }
    return worst;
}

void check_shading(const Run &run, const Scene &scene, const RayScene &rays,
                   double extent, Report &report)
{
    PictureCamera camera(scene.camera, run.width, run.height);
    Receivers receivers(run);
    Picture image = load_file(run, "image.exr", run.width, run.height, 3);
    size_t shown = 0, apart = 0, wrong = 0;
    double worst = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown)
                continue;
            shown++;
            Ray ray{{}, camera.ray(x + 0.5, y + 0.5)};
            Hit hit = rays.first(ray);
            double depth = camera.pixel_of(r.position).z;
            if (!hit.found() ||
                std::abs(hit.distance - depth) > 1e-3 * extent) {
                apart++;
                continue;
            }
            const MapView &view = run.views[size_t(r.layer)];
            double light =
                std::max(cosine_to_light(r.normal, view, r.position), 0.0);
            light *= r.visibility * arriving(scene.light, view, r.position);
            int object = rays.triangle(hit.triangle).object;
            double off =
                worst_channel(scene, scene.objects[object], light, image, x, y);
            worst = std::max(worst, off);
            wrong += off <= TOLERANCE ? 0 : 1;
        }
    // Where two objects meet, one may be shown and the other one met.
    report.line(double(wrong) <= 0.001 * double(shown) &&
                    double(apart) <= MOST_APART * double(shown),
                "image is albedo, light and visibility",
                "%zu of %zu pixels off, worst %.3g, %zu at outlines apart",
                wrong, shown, worst, apart);
}
