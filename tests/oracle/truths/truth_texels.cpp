#include <cmath>  // floor
#include <memory> // shared_ptr

#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/rays/own_plane.h"
#include "tests/oracle/filters/poisson_disc.h"
#include "tests/oracle/truths/truth.h"

// The mean of lit(x, y), a number or several, over a disc's taps.
template <typename Lit>
static auto disc_mean_of(const Pixel &pixel, const Receiver &r,
                         const MapView &view, int width, const Lit &lit)
{
    decltype(lit(0, 0)) count(0);
    for (const glm::dvec2 &tap : poisson_taps(pixel.x, pixel.y))
        count += lit(int(std::floor(r.u * view.width + width * tap.x / 2)),
                     int(std::floor(r.v * view.height + width * tap.y / 2)));
    return count / double(POISSON_TAPS);
}

// The mean of lit(x, y) over the texels, with the weights of the step's whole
// filter at the receiver.
template <typename Lit>
static auto mean_of(const TruthScene &scene, const Pixel &pixel,
                    const Receiver &r, const Lit &lit)
{
    const MapView &view = scene.view(r);
    int step = scene.run.step;
    Settings settings = scene.run.settings;
    settings.kernel =
        scene.widths.at(r, pixel.x, pixel.y, view.width, view.height).front();
    if (settings.poisson)
        return disc_mean_of(pixel, r, view, settings.kernel, lit);
    auto across = filter_footprint(step, r.u, view.width, settings);
    auto up = filter_footprint(step, r.v, view.height, settings);
    decltype(lit(0, 0)) share(0);
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++)
            share += across.weights[i] * up.weights[j] *
                     lit(across.first + int(i), up.first + int(j));
    return share;
}

// The mean of lit(sample) over the samples of a texel.
template <typename Sample, typename Lit>
static auto mean_of_samples(const std::vector<Sample> &samples, const Lit &lit)
{
    decltype(lit(samples[0])) sum(0);
    for (const Sample &sample : samples)
        sum += lit(sample);
    return sum / double(samples.size());
}

Truth lower_truth(const TruthScene &scene, double ties)
{
    auto maps = std::make_shared<std::vector<std::vector<Picture>>>();
    for (size_t layer = 0; layer < scene.run.views.size(); layer++)
        maps->push_back(load_samples(scene.run, int(layer)));
    auto at = [&scene, maps, ties](const Pixel &pixel,
                                   const Receiver &r) -> TruthValue {
        const std::vector<Picture> &samples = (*maps)[size_t(r.layer)];
        return {mean_of(scene, pixel, r, [&](int x, int y) {
            return mean_of_samples(samples, [&](const Picture &map) {
                bool lit =
                    !map.holds(x, y) || double(map.at(x, y)) >= r.t - ties;
                return lit ? 1.0 : 0.0;
            });
        })};
    };
    return {"lower", [&scene, at](const Pixel &pixel) {
                return over_layers(scene, pixel, at);
            }};
}

// Whether an ideal texel is lit, 1 or 0: at its place; for an outline's texel,
// also whether it is at all points around, and at any.
static glm::dvec3 compare(const IdealMap &map, const OwnPlane &plane,
                          double slack, int x, int y)
{
    if (!map.holds(x, y))
        return glm::dvec3(1);
    auto own = [&](double dx, double dy) {
        return plane.depth((x + map.place().x + dx) / map.width(),
                           (y + map.place().y + dy) / map.height()) -
               slack;
    };
    bool middle = map.at(x, y) >= own(0, 0), all = middle, any = middle;
    const std::array<double, 4> *around = map.around(x, y);
    for (size_t k = 0; around != nullptr && k < 4; k++) {
        bool here = (*around)[k] >= own(IdealMap::SNAP * IdealMap::SNAP_X[k],
                                        IdealMap::SNAP * IdealMap::SNAP_Y[k]);
        all = all && here;
        any = any || here;
    }
    return {middle ? 1 : 0, all ? 1 : 0, any ? 1 : 0};
}

Truth pcf_truth(const TruthScene &scene, double ties)
{
    auto at = [&scene, ties](const Pixel &pixel,
                             const Receiver &r) -> TruthValue {
        if (!pixel.surface.found)
            return {1, true};
        const std::vector<IdealMap> &maps = scene.ideal[size_t(r.layer)];
        OwnPlane plane(scene.view(r), pixel.surface.point,
                       pixel.surface.normal);
        double slack = ties * scene.tie_rounding(scene.view(r));
        glm::dvec3 lit = mean_of(scene, pixel, r, [&](int x, int y) {
            return mean_of_samples(maps, [&](const IdealMap &map) {
                return compare(map, plane, slack, x, y);
            });
        });
        return {lit.x, false, lit.x - lit.y, lit.z - lit.x};
    };
    return {"pcf", [&scene, at](const Pixel &pixel) {
                return over_layers(scene, pixel, at);
            }};
}
