#include "tests/oracle/checks/stability_rows.h"

#include <algorithm> // copy, max, min
#include <cmath>     // abs, floor
#include <cstddef>   // before the C headers, outside extern "C"
#include <cstdint>
#include <memory> // unique_ptr

extern "C" {
#include "tests/stability/bound.h"
#include "tests/stability/search.h"
}

#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/dump/light.h"
#include "tests/oracle/lib/verdict.h" // BadInput
#include "tests/oracle/checks/stability_auto.h"

// Wide filters have many texels: fewer windows of them are compared.
static constexpr double MOST_TEXELS = 2e7;
static constexpr int SEARCH_STEPS = 600;

// What the program does to the depths of its map.
static Chain chain_of(const Run &run)
{
    const Settings &s = run.settings;
    if (s.mips || s.sat || s.msaa > 1 || s.slope_term || s.downsample > 2 ||
        s.blur == Blur::BOXES || 2 * s.radius + 1 > MAX_TAPS)
        throw BadInput("stability: no bound for such a filter");
    Chain chain{};
    chain.central = s.central;
    // The program rounds central moments itself; raw ones the driver may cut
    // off.
    chain.format = &formats[!s.half ? FP32 : s.central ? FP16 : FP16_TRUNCATED];
    chain.lookup = run.step == 5 ? LOOKUP_BILINEAR : LOOKUP_NONE;
    chain.factor = s.downsample;
    chain.taps = 2 * s.radius + 1;
    std::vector<double> weights = blur_weights(s);
    for (size_t i = 0; i < weights.size(); i++)
        chain.weights[i] = float(weights[i]);
    return chain;
}

// The depths that the chain reads, the first of them at x, y of the map.
static void fill_window(const Chain &chain, const Picture &map, int x, int y,
                        Window &window)
{
    int side = chain_side(&chain);
    for (int j = 0; j < side; j++)
        for (int i = 0; i < side; i++)
            window.depths[j * side + i] =
                map.holds(x + i, y + j) ? map.at(x + i, y + j) : 1;
}

// The window where the largest part of a bound was reached.
static void start_there(const void *context, Random *, Place *place)
{
    *place = *static_cast<const Place *>(context);
}

static double search_from(const Chain &chain, Quantity quantity, bool guarded,
                          const Window &window)
{
    auto place = std::make_unique<Place>();
    int side = chain_side(&chain);
    place->window = window;
    auto range =
        std::minmax_element(window.depths, window.depths + side * side);
    place->low = *range.first;
    place->high = *range.second;
    place->reach = place->high - place->low;
    SearchCase search{};
    search.chain = chain;
    search.quantity = quantity;
    search.guarded = guarded;
    search.steps = side > 40 ? SEARCH_STEPS / 10 : SEARCH_STEPS;
    search.seed = 1;
    search.start = start_there;
    search.context = place.get();
    return search_worst(&search);
}

// Every how manieth of so many windows.
static int stride_of(const Chain &chain, double windows)
{
    double texels = windows * chain_side(&chain) * chain_side(&chain);
    return std::max(1, int(std::ceil(std::sqrt(texels / MOST_TEXELS))));
}

StabilityRow variance_row(const Run &run)
{
    StabilityRow row{"variance"};
    Chain chain = chain_of(run);
    auto window = std::make_unique<Window>(),
         worst = std::make_unique<Window>();
    for (size_t layer = 0; layer < run.views.size(); layer++) {
        Picture map = load_map(run, int(layer));
        Picture filtered = load_filtered(run, int(layer));
        int stride = stride_of(chain, double(filtered.width) * filtered.height *
                                          double(run.views.size()));
        for (int y = 0; y < filtered.height; y += stride)
            for (int x = 0; x < filtered.width; x += stride) {
                int f = chain.factor, radius = run.settings.radius;
                fill_window(chain, map, (x - radius) * f, (y - radius) * f,
                            *window);
                Exact truth = exact(&chain, window.get());
                double m1 = filtered.at(x, y, 0), second = filtered.at(x, y, 1);
                double variance =
                    chain.central ? second : std::max(second - m1 * m1, 0.0);
                row.all++;
                if (row.add(std::abs(variance - truth.variance),
                            variance_bound(&chain, &truth)))
                    *worst = *window;
            }
    }
    worst->t = worst->depths[0];
    row.searched =
        std::max(row.ratio, search_from(chain, OF_VARIANCE, false, *worst));
    return row;
}

namespace
{

// A pixel's window and what is right for it.
struct Seen {
    double p = 0, bound = 0;
    double least = INFINITY; // p, over what rounding makes of the position
};

// What looks at pixels one by one.
struct Eye {
    const Run &run;
    Chain chain;
    MostWithAuto with_auto; // empty: nothing is added
    std::vector<Picture> maps;
    std::unique_ptr<Window> window = std::make_unique<Window>();

    explicit Eye(const Run &of) : run(of), chain(chain_of(of))
    {
        if (run.settings.auto_variance)
            with_auto = most_with_auto(run);
        for (size_t layer = 0; layer < run.views.size(); layer++)
            maps.push_back(load_map(run, int(layer)));
    }

    Seen see(const Receiver &r);

  private:
    double bound(const Receiver &r, const Exact &truth) const;
};

// The largest error of those whose bound promises nothing.
struct Open {
    double error = 0, bound = 1;
};

} // namespace

// With auto p is not below the exact one.
double Eye::bound(const Receiver &r, const Exact &truth) const
{
    if (!with_auto)
        return p_bound(&chain, &truth, false);
    Computed most = computed_most(&chain, &truth);
    double p = with_auto(r, {most.mean, most.variance, most.m2});
    return std::max(p - truth.p, 0.0) + LAST_ROUNDINGS;
}

// Where the lookup falls between texels is right to a rounding of u and v, as
// an input: that can move p by as much as it moves the exact one.
Seen Eye::see(const Receiver &r)
{
    const MapView &view = run.views[size_t(r.layer)];
    int f = chain.factor, radius = run.settings.radius;
    int width = view.width / f, height = view.height / f;
    double x = r.u * width - 0.5, y = r.v * height - 0.5;
    Shifts shifts = lookup_shifts(r.u, r.v, width, height);
    Seen seen;
    double most = -INFINITY;
    shifts.x.push_back(0);
    shifts.y.push_back(0); // last: what is kept
    for (double dy : shifts.y)
        for (double dx : shifts.x) {
            double left = std::floor(x + dx), low = std::floor(y + dy);
            chain.across = float(x + dx - left);
            chain.up = float(y + dy - low);
            fill_window(chain, maps[size_t(r.layer)], (int(left) - radius) * f,
                        (int(low) - radius) * f, *window);
            window->t = float(r.t);
            Exact truth = exact(&chain, window.get());
            seen.p = truth.p;
            seen.bound = std::max(seen.bound, bound(r, truth));
            seen.least = std::min(seen.least, truth.p);
            most = std::max(most, truth.p);
        }
    seen.bound = std::min(seen.bound + (most - seen.least), 1.0);
    return seen;
}

static bool in_map(const Run &run, const Receiver &r)
{
    return r.shown && r.share == 0 && inside_map(r) &&
           facing(r, run.views[size_t(r.layer)]) == Facing::TOWARDS;
}

// What the light-bleeding reduction by A makes of p: clamp((p - A) / (1 - A)).
// Its errors are magnified by 1 / (1 - A), those of its own arithmetic too: A
// is rounded, and so are two differences and the quotient.
static void reduce(double a, Seen &seen)
{
    auto reduced = [a](double p) {
        return std::clamp((p - a) / (1 - a), 0., 1.);
    };
    double own = 8 * ROUNDOFF / (1 - a);
    double p = reduced(seen.p);
    double up = reduced(std::min(seen.p + seen.bound, 1.0)) - p;
    double down = p - reduced(seen.p - seen.bound);
    seen.bound = std::min(std::max(up, down) + own, 1.0);
    seen.least = reduced(seen.least) - own;
    seen.p = p;
}

// The bounds are of step 5 without what changes p for the picture's sake.
static void check_settings(const Settings &s)
{
    if (s.smooth || s.variance_bias != 0 ||
        (!s.auto_variance && s.min_variance != 0))
        throw BadInput("stability: no bound for such a p");
}

StabilityRow p_row(const Run &run)
{
    const Settings &s = run.settings;
    check_settings(s);
    StabilityRow row{"p"};
    Eye eye(run);
    Receivers receivers(run);
    Chain worst_chain = eye.chain;
    auto worst = std::make_unique<Window>();
    Open open;
    size_t capped = 0;
    int stride = stride_of(eye.chain, 4.0 * run.width * run.height);
    for (int y = 0; y < run.height; y += stride)
        for (int x = 0; x < run.width; x += stride) {
            Receiver r = receivers.at(x, y);
            if (!in_map(run, r))
                continue;
            Seen seen = eye.see(r);
            if (s.reduces())
                reduce(s.bleed_reduction, seen);
            double error = std::abs(r.visibility - seen.p);
            if (s.auto_variance)
                row.below = std::max(row.below, seen.least - r.visibility);
            // In front of the mean p is 1 without any arithmetic: that has to
            // be so, and is not counted.
            if (seen.p == 1 && error <= seen.bound)
                continue;
            row.all++;
            if (seen.bound > NO_PROMISE && error <= seen.bound) {
                if (error >= open.error)
                    open = {error, seen.bound};
            } else if (s.auto_variance && seen.p + seen.bound >= 1 &&
                       error <= seen.bound) {
                // p can be 1: the error is what was missing of it.
                capped++;
            } else if (row.add(error, seen.bound)) {
                *worst = *eye.window;
                worst_chain = eye.chain;
            }
        }
    row.compared += row.compared > 0 ? capped : 0;
    if (row.compared > 0 && !s.reduces())
        row.searched = std::max(
            row.ratio, search_from(worst_chain, OF_P, s.auto_variance, *worst));
    row.open_error = open.error;
    row.open_bound = open.bound;
    return row;
}
