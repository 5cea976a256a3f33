#include <memory> // shared_ptr

#include "tests/oracle/footprint.h"
#include "tests/oracle/light.h" // inside_map
#include "tests/oracle/truth.h"

// The weight of the texels for which lit(x, y) holds, with the step's whole
// filter at the receiver.
template <typename Lit>
static double weight_of(const TruthScene &scene, const Receiver &r,
                        const Lit &lit)
{
    const MapView &view = scene.view(r);
    const Run &run = scene.run;
    auto across = filter_footprint(run.step, r.u, view.width, run.settings);
    auto up = filter_footprint(run.step, r.v, view.height, run.settings);
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
    auto at = [&scene, maps, ties](const Pixel &pixel) -> TruthValue {
        const Receiver &r = pixel.receiver;
        if (!inside_map(r))
            return {1};
        const Picture &map = (*maps)[size_t(r.layer)];
        return {weight_of(scene, r, [&](int x, int y) {
            return !map.holds(x, y) || double(map.at(x, y)) >= r.t - ties;
        })};
    };
    return {"lower", at};
}

Truth pcf_truth(const TruthScene &scene, double ties)
{
    auto at = [&scene, ties](const Pixel &pixel) -> TruthValue {
        const Receiver &r = pixel.receiver;
        if (!inside_map(r))
            return {1};
        if (!pixel.surface.found)
            return {1, true};
        const IdealMap &map = scene.ideal[size_t(r.layer)];
        const MapPlane &plane = pixel.surface.plane;
        double slack = ties * scene.tie_rounding(scene.view(r));
        return {weight_of(scene, r, [&](int x, int y) {
            double own =
                plane.at((x + 0.5) / map.width(), (y + 0.5) / map.height());
            return map.at(x, y) >= own - slack;
        })};
    };
    return {"pcf", at};
}
