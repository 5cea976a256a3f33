#include "tests/oracle/dump/looked_up.h"

#include <algorithm> // max, min
#include <climits>   // INT_MAX
#include <cmath>     // floor

#include "tests/oracle/dump/light.h" // facing, inside_map

// The outermost texels that are looked up, and how many lookups there are.
struct Outermost {
    int low[2] = {INT_MAX, INT_MAX}, high[2] = {-INT_MAX, -INT_MAX};
    size_t lookups = 0, outside = 0;
};

static void add_lookup(const Run &run, const Receiver &receiver,
                       std::vector<Outermost> &layers)
{
    if (receiver.layer >= int(run.views.size()) || !inside_map(receiver))
        return;
    const MapView &view = run.views[size_t(receiver.layer)];
    Outermost &layer = layers[size_t(receiver.layer)];
    int size[2] = {view.width, view.height};
    double place[2] = {receiver.u, receiver.v};
    bool held = true;
    layer.lookups++;
    for (int axis = 0; axis < 2; axis++) {
        int texel =
            std::min(int(std::floor(place[axis] * size[axis])), size[axis] - 1);
        layer.low[axis] = std::min(layer.low[axis], texel);
        layer.high[axis] = std::max(layer.high[axis], texel + 1);
        held = held && texel >= view.looked_up[size_t(axis)] &&
               texel < view.looked_up[size_t(axis) + 2];
    }
    layer.outside += held ? 0 : 1;
}

static double texels(double width, double height)
{
    return std::max(width, 0.0) * std::max(height, 0.0);
}

// Texels around what is looked up that rounding alone may ask for.
static const int AROUND = 4;

void check_looked_up(const Run &run, double most, Report &report)
{
    std::vector<Outermost> layers(run.views.size());
    Receivers receivers(run);
    for (int i = 0; i < run.width * run.height; i++) {
        Receiver receiver = receivers.at(i % run.width, i / run.width);
        if (!receiver.shown ||
            facing(receiver, run.views[size_t(receiver.layer)]) !=
                Facing::TOWARDS)
            continue;
        add_lookup(run, receiver, layers);
        if (receiver.share > 0)
            add_lookup(run, receiver.in_next(), layers);
    }
    double asked = 0, needed = 0;
    for (size_t i = 0; i < layers.size(); i++) {
        const Outermost &layer = layers[i];
        const std::array<int, 4> &rect = run.views[i].looked_up;
        report.line(
            layer.outside == 0, "looked up of layer " + std::to_string(i),
            "%zu of %zu lookups outside of [%d %d %d %d]", layer.outside,
            layer.lookups, rect[0], rect[1], rect[2], rect[3]);
        asked += texels(rect[2] - rect[0], rect[3] - rect[1]);
        if (layer.lookups > 0)
            needed += texels(layer.high[0] - layer.low[0] + 2 * AROUND,
                             layer.high[1] - layer.low[1] + 2 * AROUND);
    }
    report.line(asked <= most * needed, "no more than is looked up",
                "%.0f texels for %.0f, at most %g times", asked, needed, most);
}
