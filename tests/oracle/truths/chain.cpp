#include "tests/oracle/truths/chain.h"

#include <algorithm> // max, min
#include <cmath>     // floor, frexp, ldexp, nearbyint
#include <memory>    // shared_ptr

#include "tests/oracle/filters/chebyshev_bound.h"
#include "tests/oracle/filters/footprint.h" // blur_weights
#include "tests/oracle/dump/light.h"        // total_bias
#include "tests/oracle/rays/own_plane.h"
#include "tests/oracle/lib/parallel.h"

namespace
{

// M1 and M2 of one layer, in double; 1 and 1 outside of it.
struct MomentMap {
    int width, height;
    std::vector<glm::dvec2> moments;

    glm::dvec2 at(int x, int y) const
    {
        bool holds = x >= 0 && y >= 0 && x < width && y < height;
        return holds ? moments[size_t(y) * size_t(width) + size_t(x)]
                     : glm::dvec2(1);
    }

    glm::dvec2 bilinear(double u, double v) const
    {
        double x = u * width - 0.5, y = v * height - 0.5;
        double left = std::floor(x), low = std::floor(y);
        int i = int(left), j = int(low);
        return glm::mix(glm::mix(at(i, j), at(i + 1, j), x - left),
                        glm::mix(at(i, j + 1), at(i + 1, j + 1), x - left),
                        y - low);
    }
};

// What a map holds of moments after they are stored.
using Store = std::function<glm::dvec2(const glm::dvec2 &)>;

} // namespace

// To the nearest float of so many bits; below the least normal one, 2^least,
// floats keep its unit. Not by conversion: g++ 12 -O2 takes two of them side by
// side, double(float(x)), for nothing to do.
static double to_float(double value, int bits, int least)
{
    int exponent = 0; // value < 2^exponent
    std::frexp(value, &exponent);
    double unit = std::ldexp(1.0, std::max(exponent - 1, least) - bits + 1);
    return std::nearbyint(value / unit) * unit;
}

static Store store_of(const Settings &settings)
{
    int bits = settings.half ? 11 : 24, least = settings.half ? -14 : -126;
    if (settings.central)
        return [=](const glm::dvec2 &m) {
            double mean = to_float(m.x, bits, least);
            double variance =
                to_float(std::max(m.y - m.x * m.x, 0.0), bits, least);
            return glm::dvec2(mean, variance + mean * mean);
        };
    return [=](const glm::dvec2 &m) {
        return glm::dvec2(to_float(m.x, bits, least),
                          to_float(m.y, bits, least));
    };
}

static MomentMap map_of(int width, int height, const Store &store,
                        const std::function<glm::dvec2(int, int)> &moments)
{
    MomentMap map{width, height, {}};
    map.moments.resize(size_t(width) * size_t(height));
    parallel_rows(height, [&](int y) {
        for (int x = 0; x < width; x++)
            map.moments[size_t(y) * size_t(width) + size_t(x)] =
                store(moments(x, y));
    });
    return map;
}

static MomentMap blurred(const MomentMap &map, const Settings &settings,
                         const glm::ivec2 &axis, const Store &store)
{
    std::vector<double> weights = blur_weights(settings);
    int radius = settings.radius;
    return map_of(map.width, map.height, store, [&](int x, int y) {
        glm::dvec2 sum(0);
        for (int i = -radius; i <= radius; i++)
            sum += weights[size_t(i + radius)] *
                   map.at(x + i * axis.x, y + i * axis.y);
        return sum;
    });
}

// As the steps make it: moments, of samples and then of texels, downsampling,
// rows, columns. A table of sums has its box exactly, so that only the moments
// themselves are stored.
static MomentMap filtered(const std::vector<IdealMap> &samples,
                          const Settings &settings, const Store &store)
{
    Store keep = [](const glm::dvec2 &m) { return m; };
    const Store &later = settings.sat ? keep : store;
    const IdealMap &one = samples.front();
    MomentMap map = map_of(one.width(), one.height(), store, [&](int x, int y) {
        glm::dvec2 sum(0);
        for (const IdealMap &ideal : samples) {
            double depth = std::min(ideal.at(x, y), 1.0);
            sum += store(glm::dvec2(depth, depth * depth));
        }
        return sum / double(samples.size());
    });
    int factor = settings.downsample;
    if (factor > 1) {
        MomentMap fine = map;
        map = map_of(fine.width / factor, fine.height / factor, later,
                     [&](int x, int y) {
                         glm::dvec2 sum(0);
                         for (int j = 0; j < factor; j++)
                             for (int i = 0; i < factor; i++)
                                 sum += fine.at(x * factor + i, y * factor + j);
                         return sum / double(factor * factor);
                     });
    }
    if (settings.radius > 0) {
        map = blurred(map, settings, {1, 0}, later);
        map = blurred(map, settings, {0, 1}, later);
    }
    return map;
}

using Maps = std::vector<MomentMap>;

static std::shared_ptr<Maps> maps_of(const TruthScene &scene,
                                     const Store &store)
{
    auto maps = std::make_shared<Maps>();
    for (const std::vector<IdealMap> &samples : scene.ideal)
        maps->push_back(filtered(samples, scene.run.settings, store));
    return maps;
}

// The visibility from the moments that a receiver at depth t looks up.
using Rule =
    std::function<double(const Receiver &, const glm::dvec2 &, double)>;

static Truth model(const TruthScene &scene, const std::string &name,
                   const std::shared_ptr<Maps> &maps, const Rule &rule)
{
    auto at = [&scene, maps, rule](const Pixel &pixel,
                                   const Receiver &r) -> TruthValue {
        if (!pixel.surface.found)
            return {1, true};
        const MapView &view = scene.view(r);
        OwnPlane plane(view, pixel.surface.point, pixel.surface.normal);
        // Its own plane lights it, as in same-weights PCF.
        double t = plane.depth(r.u, r.v) - scene.tie_rounding(view);
        return {rule(r, (*maps)[size_t(r.layer)].bilinear(r.u, r.v), t)};
    };
    return {name, [&scene, at](const Pixel &pixel) {
                return over_layers(scene, pixel, at);
            }};
}

// Steps 3 and 4.
static Rule compared_mean(const TruthScene &scene)
{
    return [&scene](const Receiver &r, const glm::dvec2 &moments, double t) {
        const MapView &view = scene.view(r);
        const Settings &settings = scene.run.settings;
        Interval bias =
            total_bias(r, view, view.width / settings.downsample,
                       view.height / settings.downsample, 1, settings);
        return t - (bias.lo + bias.hi) / 2 <= moments.x ? 1.0 : 0.0;
    };
}

// Step 5, with these of its settings.
static Rule bound(const TruthScene &scene, const Settings &settings)
{
    Run run = scene.run;
    run.settings = settings;
    Formula formula(run);
    return [&scene, formula](const Receiver &r, const glm::dvec2 &moments,
                             double t) {
        double variance = std::max(moments.y - moments.x * moments.x, 0.0);
        return chebyshev_exact(moments.x, variance, t,
                               depth_noise(scene.view(r), r.position), formula);
    };
}

std::vector<Truth> models_of(const TruthScene &scene)
{
    const Run &run = scene.run;
    if (run.step < 3 || !run.settings.has_weights())
        return {};
    auto exact = maps_of(scene, [](const glm::dvec2 &m) { return m; });
    auto stored = maps_of(scene, store_of(run.settings));
    if (run.step < 5)
        return {model(scene, "mean", exact, compared_mean(scene)),
                model(scene, "format", stored, compared_mean(scene))};
    Settings floored = run.settings;
    floored.bleed_reduction = 0;
    floored.smooth = false;
    Settings bare = floored;
    bare.auto_variance = false;
    bare.min_variance = bare.variance_bias = 0;
    return {model(scene, "chebyshev", exact, bound(scene, bare)),
            model(scene, "floor", exact, bound(scene, floored)),
            model(scene, "reduction", exact, bound(scene, run.settings)),
            model(scene, "format", stored, bound(scene, run.settings))};
}
