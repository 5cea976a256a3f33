#include <cmath> // abs, INFINITY

#include "tests/oracle/dump/light.h"
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/truths/truth.h"

static constexpr double GRAZING = 0.1; // N.L

TruthScene::TruthScene(const Run &the_run)
    : run(the_run), table(run.scene, run.light), rays(table.scene, run.origin),
      camera(table.scene.camera, run.width, run.height), receivers(run),
      extent(scene_extent(table.scene, run.origin)),
      // Embree's vertices and the ray's origin are off by a unit each.
      lift(rounding_share(16) * extent), widths(run)
{
    for (const MapView &view : run.views) {
        ideal.emplace_back();
        for (const glm::dvec2 &place : run.places)
            ideal.back().emplace_back(view, rays, place);
    }
}

// The triangle that a ray within SUBPIXEL of the pixel's centre meets, when
// position.exr lies on its plane.
static Surface surface_at(const TruthScene &scene, int x, int y,
                          const Receiver &r)
{
    for (double dy : {0.0, -SUBPIXEL, SUBPIXEL})
        for (double dx : {0.0, -SUBPIXEL, SUBPIXEL}) {
            Ray ray{{}, scene.camera.ray(x + 0.5 + dx, y + 0.5 + dy)};
            Hit hit = scene.rays.first(ray);
            if (!hit.found())
                continue;
            const Triangle &triangle = scene.rays.triangle(hit.triangle);
            glm::dvec3 n = normal_towards(triangle, -ray.direction);
            double off = glm::dot(n, r.position - triangle.a);
            if (std::abs(off) > rounding_share(64) * scene.extent)
                continue;
            glm::dvec3 point = r.position - off * n;
            return {true, triangle.object, point, n};
        }
    return {false, -1, r.position, r.normal};
}

Pixel TruthScene::pixel(int x, int y) const
{
    Pixel pixel{x, y, receivers.at(x, y), {}, false, false};
    const Receiver &r = pixel.receiver;
    if (!r.shown || facing(r, view(r)) != Facing::TOWARDS)
        return pixel;
    pixel.counts = true;
    pixel.surface = surface_at(*this, x, y, r);
    pixel.grazing =
        cosine_to_light(r.normal, view(r), r.position) < GRAZING ||
        cosine_to_light(pixel.surface.normal, view(r), r.position) < GRAZING;
    return pixel;
}

bool TruthScene::lit(const MapView &view, const glm::dvec3 &point) const
{
    return !rays.occluded({point, towards_light(view, point)},
                          view.parallel() ? INFINITY : 1);
}

TruthValue over_layers(const TruthScene &scene, const Pixel &pixel,
                       const LayerTruth &at)
{
    auto in_layer = [&](const Receiver &r) {
        bool held = size_t(r.layer) < scene.run.views.size();
        return held && inside_map(r) ? at(pixel, r) : TruthValue{1};
    };
    const Receiver &r = pixel.receiver;
    TruthValue own = in_layer(r);
    if (r.share == 0)
        return own;
    TruthValue next = in_layer(r.in_next());
    auto mixed = [&](double a, double b) {
        return (1 - r.share) * a + r.share * b;
    };
    return {mixed(own.value, next.value), own.apart || next.apart,
            mixed(own.below, next.below), mixed(own.above, next.above)};
}

double TruthScene::tie_rounding(const MapView &view) const
{
    // Three vertices, rounded to float in the mesh, carry the plane, and it
    // is drawn out by about its own size. The rest is in double.
    double world = extent; // the scene table is in world space
    for (int i = 0; i < 3; i++)
        world = std::max(world, extent + std::abs(run.origin[i]));
    return rounding_share(4) * depth_size(view, extent) +
           0x1p-46 * depth_size(view, world);
}

double TruthScene::float_rounding(const MapView &view) const
{
    return rounding_share(16) * depth_size(view, extent);
}
