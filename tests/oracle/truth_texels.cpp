#include <cmath>  // floor
#include <memory> // shared_ptr

#include "tests/oracle/footprint.h"
#include "tests/oracle/own_plane.h"
#include "tests/oracle/poisson_disc.h"
#include "tests/oracle/truth.h"

// The weight of a disc's taps for which lit(x, y) holds.
template <typename Lit>
static double disc_weight_of(const Pixel &pixel, const Receiver &r,
                             const MapView &view, int width, const Lit &lit)
{
    int count = 0;
    for (const glm::dvec2 &tap : poisson_taps(pixel.x, pixel.y))
        count += lit(int(std::floor(r.u * view.width + width * tap.x / 2)),
                     int(std::floor(r.v * view.height + width * tap.y / 2)));
    return double(count) / POISSON_TAPS;
}

// The weight of the texels for which lit(x, y) holds, with the step's whole
// filter at the receiver.
template <typename Lit>
static double weight_of(const TruthScene &scene, const Pixel &pixel,
                        const Receiver &r, const Lit &lit)
{
    const MapView &view = scene.view(r);
    int step = scene.run.step;
    Settings settings = scene.run.settings;
    settings.kernel =
        scene.widths.at(r, pixel.x, pixel.y, view.width, view.height).front();
    if (settings.poisson)
        return disc_weight_of(pixel, r, view, settings.kernel, lit);
    auto across = filter_footprint(step, r.u, view.width, settings);
    auto up = filter_footprint(step, r.v, view.height, settings);
    double share = 0;
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++)
            if (lit(across.first + int(i), up.first + int(j)))
                share += across.weights[i] * up.weights[j];
    return share;
}

Truth lower_truth(const TruthScene &scene, double ties)
{
    auto maps = std::make_shared<std::vector<Picture>>();
    for (size_t layer = 0; layer < scene.run.views.size(); layer++)
        maps->push_back(load_map(scene.run, int(layer)));
    auto at = [&scene, maps, ties](const Pixel &pixel,
                                   const Receiver &r) -> TruthValue {
        const Picture &map = (*maps)[size_t(r.layer)];
        return {weight_of(scene, pixel, r, [&](int x, int y) {
            return !map.holds(x, y) || double(map.at(x, y)) >= r.t - ties;
        })};
    };
    return {"lower", [&scene, at](const Pixel &pixel) {
                return over_layers(scene, pixel, at);
            }};
}

// Whether an ideal texel is lit: at its centre; for an outline's texel, also
// whether it is at all points around, and at any.
namespace
{
struct Lit {
    bool middle, all, any;
};
} // namespace

static Lit compare(const IdealMap &map, const OwnPlane &plane, double slack,
                   int x, int y)
{
    auto own = [&](double dx, double dy) {
        return plane.depth((x + 0.5 + dx) / map.width(),
                           (y + 0.5 + dy) / map.height()) -
               slack;
    };
    bool middle = map.at(x, y) >= own(0, 0);
    Lit lit{middle, middle, middle};
    const std::array<double, 4> *around = map.around(x, y);
    for (size_t k = 0; around != nullptr && k < 4; k++) {
        bool here = (*around)[k] >= own(IdealMap::SNAP * IdealMap::SNAP_X[k],
                                        IdealMap::SNAP * IdealMap::SNAP_Y[k]);
        lit.all = lit.all && here;
        lit.any = lit.any || here;
    }
    return lit;
}

Truth pcf_truth(const TruthScene &scene, double ties)
{
    auto at = [&scene, ties](const Pixel &pixel,
                             const Receiver &r) -> TruthValue {
        if (!pixel.surface.found)
            return {1, true};
        const IdealMap &map = scene.ideal[size_t(r.layer)];
        OwnPlane plane(scene.view(r), pixel.surface.point,
                       pixel.surface.normal);
        double slack = ties * scene.tie_rounding(scene.view(r));
        auto weight = [&](bool Lit::*which) {
            return weight_of(scene, pixel, r, [&](int x, int y) {
                bool inside =
                    x >= 0 && y >= 0 && x < map.width() && y < map.height();
                return !inside || compare(map, plane, slack, x, y).*which;
            });
        };
        double middle = weight(&Lit::middle);
        return {middle, false, middle - weight(&Lit::all),
                weight(&Lit::any) - middle};
    };
    return {"pcf", [&scene, at](const Pixel &pixel) {
                return over_layers(scene, pixel, at);
            }};
}
