#include <algorithm> // max
#include <cmath>     // abs, isnan

#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/dump/light.h"
#include "tests/oracle/closed/two_depths.h"

// The closed form is for any share of the upper occluder; a filter has only
// some of them, and near the worst share p is flat: 2 % is one such step.
static constexpr double TOLERANCE = 0.02;

namespace
{

struct BleedMap {
    MapView view;
    double floor; // depth t
    std::vector<Place> under_upper, under_lower;
};

} // namespace

// All of the filter sees the upper or the lower occluder: nothing is lit.
static bool all_covered(const BleedMap &map, const Footprint &across,
                        const Footprint &up)
{
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++) {
            int x = across.first + int(i), y = up.first + int(j);
            if (across.weights[i] * up.weights[j] == 0)
                continue;
            if (x < 0 || y < 0 || x >= map.view.width || y >= map.view.height)
                return false;
            size_t texel = size_t(y) * size_t(map.view.width) + size_t(x);
            if (map.under_upper[texel] != Place::INSIDE &&
                map.under_lower[texel] != Place::INSIDE)
                return false;
        }
    return true;
}

static bool on_floor_in_shadow(const Run &run, const BleedMap &map,
                               const Receiver &r, double nearer)
{
    if (!r.shown || !inside_map(r) || facing(r, map.view) != Facing::TOWARDS ||
        std::abs(r.t - map.floor) >= std::abs(r.t - nearer))
        return false;
    return all_covered(map,
                       lookup_footprint(r.u, 0, map.view.width, run.settings),
                       lookup_footprint(r.v, 0, map.view.height, run.settings));
}

static double brightest(const Run &run, const BleedMap &map, double nearer,
                        size_t &count)
{
    Receivers receivers(run);
    double most = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!on_floor_in_shadow(run, map, r, nearer))
                continue;
            count++;
            if (std::isnan(r.visibility)) // max would hide it
                return r.visibility;
            most = std::max(most, r.visibility);
        }
    return most;
}

void check_bleed(const Run &run, const SceneTable &table, double r,
                 Report &report)
{
    if (run.step != 5 || run.settings.bleed_reduction != 0 || run.settings.soft)
        throw BadInput("bleed needs step 5 with bleed-reduction 0, not --soft");
    if (run.settings.msaa > 1)
        throw BadInput("bleed knows no texels of several depths");
    MapRectangle upper(table, run, "upper"), lower(table, run, "lower");
    MapRectangle floor(table, run, "floor");
    double gap = floor.depth() - lower.depth();
    double own_r = (lower.depth() - upper.depth()) / gap;
    report.line(std::abs(own_r - r) <= 1e-6 * r, "bleed: the scene's gaps",
                "r = %.6g, asked for %.6g", own_r, r);
    BleedMap map{run.views.at(0), floor.depth(), places(upper, run.views.at(0)),
                 places(lower, run.views.at(0))};
    size_t count = 0;
    double measured = brightest(run, map, lower.depth(), count);
    double predicted = (r / (r + 2)) * (r / (r + 2));
    bool close = std::abs(measured - predicted) <= TOLERANCE * predicted;
    report.line(close && count > 0, "bleed: worst visibility in full shadow",
                "%.4g, predicted %.4g, in %zu pixels", measured, predicted,
                count);
}
