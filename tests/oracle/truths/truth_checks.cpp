#include "tests/oracle/truths/truth_checks.h"

#include <algorithm> // min, max
#include <cmath>     // abs, INFINITY

#include "tests/oracle/filters/axis_kernel.h"
#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/dump/light.h" // inside_map

// Weights of texels, added up in double in another order.
static constexpr double OWN_ROUNDING = 1e-9;

static void for_each_counted(const TruthScene &scene,
                             const std::function<void(const Pixel &)> &work)
{
    for (int y = 0; y < scene.run.height; y++)
        for (int x = 0; x < scene.run.width; x++) {
            Pixel pixel = scene.pixel(x, y);
            if (pixel.counts)
                work(pixel);
        }
}

// A floor and nothing that casts.
static void check_all_lit(const TruthScene &scene, const Truth &truth,
                          Report &report)
{
    size_t pixels = 0, wrong = 0;
    for_each_counted(scene, [&](const Pixel &pixel) {
        TruthValue value = truth.at(pixel);
        pixels++;
        wrong +=
            std::abs(value.value - 1) < OWN_ROUNDING && !value.apart ? 0 : 1;
    });
    report.line(wrong == 0 && pixels > 0,
                "truths: " + truth.name + " of an empty floor is 1",
                "%zu of %zu pixels are not", wrong, pixels);
}

// There every texel is a tie: with ties dark, only those that see nothing at
// all are lit, which no slack can darken.
static void check_all_ties(const TruthScene &scene, Report &report)
{
    Truth dark = pcf_truth(scene, -1), nothing = pcf_truth(scene, -INFINITY);
    size_t pixels = 0, wrong = 0;
    for_each_counted(scene, [&](const Pixel &pixel) {
        double empty = nothing.at(pixel).value;
        double error = std::abs(dark.at(pixel).value - empty);
        pixels += empty < 1 ? 1 : 0;
        wrong += error < OWN_ROUNDING ? 0 : 1;
    });
    report.line(wrong == 0 && pixels > 0,
                "truths: an empty floor is as deep as its own plane",
                "%zu of %zu pixels see a texel that is not", wrong, pixels);
}

// The weight of the samples whose stored depth is not the ideal one: at
// outlines the rasteriser may differ by SUBPIXEL (the check `rays` has them).
static double weight_of_outlines(const TruthScene &scene, const Receiver &r,
                                 const std::vector<Picture> &stored)
{
    const MapView &view = scene.view(r);
    const Run &run = scene.run;
    const std::vector<IdealMap> &ideal = scene.ideal[size_t(r.layer)];
    double rounding = scene.float_rounding(view), weight = 0;
    auto across = filter_footprint(run.step, r.u, view.width, run.settings);
    auto up = filter_footprint(run.step, r.v, view.height, run.settings);
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++) {
            int x = across.first + int(i), y = up.first + int(j);
            for (size_t k = 0; k < stored.size() && stored[k].holds(x, y);
                 k++) {
                double depth = std::min(ideal[k].at(x, y), 1.0);
                if (std::abs(double(stored[k].at(x, y)) - depth) > rounding)
                    weight += across.weights[i] * up.weights[j];
            }
        }
    return weight / double(stored.size());
}

void check_lower_is_pcf(const TruthScene &scene, Report &report)
{
    double ties = 2 * scene.float_rounding(scene.run.views.at(0));
    Truth strict = lower_truth(scene), lower = lower_truth(scene, ties);
    Truth pcf = pcf_truth(scene);
    std::vector<Picture> stored = load_samples(scene.run, 0);
    size_t pixels = 0, wrong = 0, above = 0, mixed = 0;
    double worst = 0;
    for_each_counted(scene, [&](const Pixel &pixel) {
        TruthValue ideal = pcf.at(pixel);
        if (ideal.apart)
            return;
        double slack = weight_of_outlines(scene, pixel.receiver, stored);
        double error = std::abs(lower.at(pixel).value - ideal.value);
        double excess = strict.at(pixel).value - ideal.value;
        pixels++;
        mixed += ideal.value > 0.01 && ideal.value < 0.99 ? 1 : 0;
        wrong += error <= slack + OWN_ROUNDING ? 0 : 1;
        above += excess <= slack + OWN_ROUNDING ? 0 : 1;
        worst = std::max(worst, error - slack);
    });
    report.line(wrong == 0 && mixed > 0, "truths: lower, ties lit, is pcf",
                "%zu of %zu pixels differ (%zu in penumbra), worst %.3g "
                "beyond the rasterised outlines",
                wrong, pixels, mixed, worst);
    report.line(above == 0, "truths: lower is not above pcf",
                "%zu of %zu pixels", above, pixels);
}

namespace
{

// The smallest upright rectangle of the map, in texels, that holds an object.
struct Box {
    glm::dvec2 low{INFINITY}, high{-INFINITY};

    Box(const TruthScene &scene, const Object &object)
    {
        const MapView &view = scene.run.views.at(0);
        glm::dvec2 size(view.width, view.height);
        for (const glm::dvec3 &p : object_points(object, scene.run.origin)) {
            glm::dvec2 texels = glm::dvec2(map_point(view, p)) * size;
            low = glm::min(low, texels);
            high = glm::max(high, texels);
        }
    }

    // Within this distance, along an axis, of the point.
    bool meets(const glm::dvec2 &point, double distance) const
    {
        return point.x + distance > low.x && point.x - distance < high.x &&
               point.y + distance > low.y && point.y - distance < high.y;
    }
};

} // namespace

// The light stands straight above. The floor beside the upright wall is lit up
// to its foot; the points of the kernel inside the wall have to be left out,
// while the wall's top is in front of pcf's texels.
static void check_beside_wall(const TruthScene &scene, double rays,
                              Report &report)
{
    Truth truth = footprint_truth(scene, rays), pcf = pcf_truth(scene);
    double reach = AxisKernel(scene.run.step, scene.run.settings).half_width();
    const MapView &view = scene.run.views.at(0);
    const Scene &table = scene.table.scene;
    size_t pixels = 0, wrong = 0, apart = 0;
    double darkest = 1;
    for_each_counted(scene, [&](const Pixel &pixel) {
        const Receiver &r = pixel.receiver;
        if (!pixel.surface.found || !inside_map(r))
            return;
        glm::dvec2 here(r.u * view.width, r.v * view.height);
        bool beside = false;
        for (int i = 0; i < table.object_count; i++) {
            const Object &object = table.objects[i];
            std::string name = object.name;
            if (name == "floor"  ? pixel.surface.object != i
                : name == "wall" ? Box(scene, object).meets(here, 0)
                                 : Box(scene, object).meets(here, reach))
                return;
            beside = beside ||
                     (name == "wall" && Box(scene, object).meets(here, reach));
        }
        if (!beside)
            return;
        TruthValue value = truth.at(pixel);
        pixels++;
        apart += value.apart ? 1 : 0;
        wrong += value.value == 1 || value.apart ? 0 : 1;
        darkest = std::min(darkest, pcf.at(pixel).value);
    });
    report.line(wrong == 0 && pixels > apart && darkest < 1,
                "truths: footprint leaves out the inside of a wall",
                "%zu of %zu pixels beside it are not 1 (%zu apart); pcf's "
                "darkest is %.3g",
                wrong, pixels, apart, darkest);
}

void check_truths(const Run &run, double rays, double light_size,
                  Report &report)
{
    TruthScene scene(run);
    std::string name = scene.table.scene.name;
    bool lower = run.step == 5 && !run.settings.reduces() && !run.settings.half;
    if (name == "empty") {
        check_all_lit(scene, pcf_truth(scene), report);
        check_all_ties(scene, report);
        check_all_lit(scene, footprint_truth(scene, rays), report);
        check_all_lit(scene, hard_truth(scene), report);
        check_all_lit(scene, area_truth(scene, rays, light_size), report);
    } else if (name == "edge") {
        check_edge_truths(scene, rays, light_size, report);
        if (lower)
            check_lower_is_pcf(scene, report);
    } else if (name == "bleed" && lower) {
        check_lower_is_pcf(scene, report);
    } else if (run.scene == "teapot:elevation=90") {
        check_beside_wall(scene, rays, report);
    } else {
        throw BadInput("truths knows no answer for " + run.scene);
    }
}
