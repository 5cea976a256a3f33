// Closed forms of the truths where a rectangle floats over a floor and the
// light is perpendicular to both. Near one of its sides, and away from its
// corners, the rectangle is a half plane.
#include <algorithm> // clamp
#include <cmath>     // abs, sqrt, asin, pow
#include <glm/gtc/constants.hpp>

#include "tests/oracle/filters/axis_kernel.h"
#include "tests/oracle/filters/footprint.h"
#include "tests/oracle/dump/light.h" // inside_map
#include "tests/oracle/lib/parallel.h"
#include "tests/oracle/lib/strata.h"
#include "tests/oracle/truths/truth_checks.h"
#include "tests/oracle/closed/two_depths.h"

namespace
{

// What a truth should be at a pixel; UNKNOWN at corners and outlines.
struct Known {
    enum { UNKNOWN, WHOLE, MIXED } kind = UNKNOWN; // MIXED: an edge crosses
    double value = 0;
};

using Answer = std::function<Known(const Pixel &)>;

// The scene as the closed forms need it.
struct EdgeScene {
    const TruthScene &scene;
    MapRectangle floor, occluder;
    glm::dvec2 sides; // the rectangle's, in world units
    double gap;       // in world units

    explicit EdgeScene(const TruthScene &the_scene)
        : scene(the_scene), floor(scene.table, scene.run, "floor"),
          occluder(scene.table, scene.run, "occluder")
    {
        const MapView &view = scene.run.views.at(0);
        const Object &object = *scene.table.find("occluder");
        for (int axis : {0, 2}) {
            glm::dvec3 side(object.transform[0][axis],
                            object.transform[1][axis],
                            object.transform[2][axis]);
            sides[axis / 2] = glm::length(side);
        }
        gap = (floor.depth() - occluder.depth()) * (view.far - view.near);
    }

    bool on_floor(const Pixel &pixel) const
    {
        double t = pixel.receiver.t;
        return std::abs(t - floor.depth()) < std::abs(t - occluder.depth());
    }

    // The receiver in the occluder's own units, as the light sees it.
    glm::dvec2 own(const Receiver &r) const
    {
        const MapView &view = scene.run.views.at(0);
        return occluder.own({r.u * view.width, r.v * view.height});
    }
};

} // namespace

// Of one pair of parallel sides: how much is seen between them and beyond,
// when everything within `reach` of the receiver is averaged. `beyond` gives
// the share that is farther out than a distance from the receiver.
static Known across_sides(double own, double reach,
                          const std::function<double(double)> &beyond)
{
    double outside = std::abs(own) - 0.5; // to the nearer side
    if (outside >= reach)
        return {Known::WHOLE, 1};
    if (outside <= -reach)
        return {Known::WHOLE, 0};
    if (reach >= 0.5) // may meet both sides
        return {};
    return {Known::MIXED, beyond(-outside)};
}

// The share that sees past a rectangle: past one pair of sides or the other.
static Known past(const Known &x, const Known &y)
{
    for (const Known *known : {&x, &y})
        if (known->kind == Known::WHOLE && known->value == 1)
            return *known;
    if (x.kind == Known::WHOLE) // 0: wholly between these sides
        return y;
    return y.kind == Known::WHOLE ? x : Known{};
}

static Known hard_answer(const EdgeScene &edge, const Pixel &pixel)
{
    glm::dvec2 own = edge.own(pixel.receiver);
    double reach = 1e-4; // the position's rounding: not tested there
    auto never = [](double) { return NAN; };
    Known known = past(across_sides(own.x, reach, never),
                       across_sides(own.y, reach, never));
    return known.kind == Known::WHOLE ? known : Known{};
}

// A disc of light of radius R at a distance of 1 is, for the receiver, a disc
// of radius R times the gap in the occluder's plane, and the edge a chord: the
// share of a unit disc beyond a chord at s is (acos s - s sqrt(1 - s^2)) / pi.
static Known area_answer(const EdgeScene &edge, const Pixel &pixel, double size)
{
    glm::dvec2 own = edge.own(pixel.receiver);
    glm::dvec2 radius = edge.gap * size / 2 / edge.sides;
    auto known = [&](int axis) {
        return across_sides(own[axis], radius[axis], [&](double distance) {
            double s = std::clamp(distance / radius[axis], -1.0, 1.0);
            return (std::acos(s) - s * std::sqrt(1 - s * s)) /
                   glm::pi<double>();
        });
    };
    return past(known(0), known(1));
}

// P(X <= x) of the sum of centred uniform variables of these widths: each box
// integrates once more, so the distribution is a sum of truncated powers,
// sum over signs of (product of signs) (x + sum of s w / 2)_+^m / m! / prod w.
static double sum_of_boxes(double x, const std::vector<double> &widths)
{
    double half = 0, factor = 1, sum = 0;
    size_t m = widths.size();
    for (size_t i = 0; i < m; i++) {
        half += widths[i] / 2;
        factor /= widths[i] * double(i + 1);
    }
    if (std::abs(x) >= half)
        return x > 0 ? 1 : 0;
    for (size_t signs = 0; signs < size_t(1) << m; signs++) {
        double shifted = x + half, sign = 1;
        for (size_t i = 0; i < m; i++)
            if (signs >> i & 1) {
                shifted -= widths[i];
                sign = -sign;
            }
        sum += shifted > 0 ? sign * std::pow(shifted, double(m)) : 0;
    }
    return sum * factor;
}

// The share of the kernel beyond a straight edge: the kernel's points, taken
// across the edge, are taps plus a sum of boxes. `per_texel` is how the
// distance grows per texel across and up.
static double kernel_beyond(const Run &run, const glm::dvec2 &per_texel,
                            double distance)
{
    const Settings &s = run.settings;
    std::vector<double> boxes = {double(s.kernel)}, taps = {1};
    if (s.bilinear)
        boxes.push_back(1);
    if (run.step >= 3) {
        boxes.assign(3, s.downsample);
        taps = blur_weights(s);
    }
    double scale = glm::length(per_texel); // texels: no tiny numbers
    glm::dvec2 normal = per_texel / scale;
    std::vector<double> widths;
    for (double box : boxes)
        for (int axis : {0, 1})
            widths.push_back(box * std::abs(normal[axis]));
    double share = 0, middle = double(taps.size() - 1) / 2;
    for (size_t j = 0; j < taps.size(); j++)
        for (size_t i = 0; i < taps.size(); i++) {
            glm::dvec2 tap(double(i) - middle, double(j) - middle);
            double at = distance / scale - s.downsample * glm::dot(tap, normal);
            share += taps[i] * taps[j] * (1 - sum_of_boxes(at, widths));
        }
    return share;
}

static Known footprint_answer(const EdgeScene &edge, const Pixel &pixel,
                              double half_width)
{
    if (!inside_map(pixel.receiver))
        return {Known::WHOLE, 1};
    glm::dvec2 own = edge.own(pixel.receiver);
    glm::dmat2 per_texel = edge.occluder.own_per_texel();
    auto known = [&](int axis) {
        const glm::dvec2 &step = per_texel[axis];
        double reach = half_width * (std::abs(step.x) + std::abs(step.y));
        return across_sides(own[axis], reach, [&](double distance) {
            return kernel_beyond(edge.scene.run, step, distance);
        });
    };
    return past(known(0), known(1));
}

// The weight of the texels that are not under the occluder.
static Known pcf_answer(const EdgeScene &edge, const Pixel &pixel)
{
    const Receiver &r = pixel.receiver;
    if (!inside_map(r))
        return {Known::WHOLE, 1};
    const Run &run = edge.scene.run;
    const MapView &view = run.views.at(0);
    auto across = filter_footprint(run.step, r.u, view.width, run.settings);
    auto up = filter_footprint(run.step, r.v, view.height, run.settings);
    double share = 0;
    for (size_t j = 0; j < up.weights.size(); j++)
        for (size_t i = 0; i < across.weights.size(); i++) {
            glm::dvec2 corner(across.first + int(i), up.first + int(j));
            double weight = across.weights[i] * up.weights[j];
            for (const glm::dvec2 &sample : run.places) {
                Place place = edge.occluder.place(corner + sample);
                if (place == Place::AMBIGUOUS)
                    return {};
                if (place == Place::OUTSIDE)
                    share += weight / double(run.places.size());
            }
        }
    bool mixed = share > 1e-9 && share < 1 - 1e-9;
    return {mixed ? Known::MIXED : Known::WHOLE, share};
}

namespace
{

struct Tally {
    size_t tested = 0, mixed = 0, unknown = 0;
    double worst_whole = 0, worst = 0, squares = 0;

    void add(const Known &known, double value)
    {
        double error = std::abs(value - known.value);
        tested += known.kind == Known::UNKNOWN ? 0 : 1;
        if (known.kind == Known::UNKNOWN) {
            unknown++;
        } else if (known.kind == Known::WHOLE) {
            worst_whole = std::max(worst_whole, error);
        } else {
            mixed++;
            worst = std::max(worst, error);
            squares += error * error;
        }
    }
    double rmse() const
    {
        return mixed ? std::sqrt(squares / double(mixed)) : 0;
    }
};

} // namespace

// `deviation` is that of the truth's sampling where an edge crosses, 0 for a
// truth without; six of them are exceeded once in 3e7 pixels (Hoeffding: twice
// e^(-2 36 / 4)).
static void compare(const EdgeScene &edge, const Truth &truth,
                    const Answer &answer, double deviation, bool soft,
                    Report &report)
{
    const Run &run = edge.scene.run;
    std::vector<Tally> rows{size_t(run.height)};
    parallel_rows(run.height, [&](int y) {
        for (int x = 0; x < run.width; x++) {
            Pixel pixel = edge.scene.pixel(x, y);
            if (!pixel.counts)
                continue;
            Known known{Known::WHOLE, 1}; // nothing is above the occluder
            if (edge.on_floor(pixel))
                known = answer(pixel);
            TruthValue value = truth.at(pixel);
            if (value.apart)
                known = {};
            rows[size_t(y)].add(known, value.value);
        }
    });
    Tally all;
    for (const Tally &row : rows) {
        all.tested += row.tested;
        all.mixed += row.mixed;
        all.unknown += row.unknown;
        all.worst_whole = std::max(all.worst_whole, row.worst_whole);
        all.worst = std::max(all.worst, row.worst);
        all.squares += row.squares;
    }
    double most = 6 * deviation + 1e-9, rmse = deviation + 1e-9;
    bool good =
        all.worst_whole <= 1e-9 && all.worst <= most && all.rmse() <= rmse;
    bool enough = all.tested > all.unknown && (all.mixed > 0 || !soft);
    report.line(good && enough,
                "truths: " + truth.name + " at an edge is its closed form",
                "worst %.3g and RMSE %.3g of %zu pixels in penumbra (at most "
                "%.3g and %.3g), worst %.3g of %zu others, %zu untested",
                all.worst, all.rmse(), all.mixed, most, rmse, all.worst_whole,
                all.tested - all.mixed, all.unknown);
}

void check_edge_truths(const TruthScene &scene, double rays, double light_size,
                       Report &report)
{
    EdgeScene edge(scene);
    bool soft = scene.run.step >= 3 || scene.run.settings.kernel > 1;
    compare(
        edge, hard_truth(scene),
        [&](const Pixel &pixel) { return hard_answer(edge, pixel); }, 0, false,
        report);
    // The disc's map bends the edge: it crosses each cell's row and column in
    // each of the map's four parts.
    compare(
        edge, area_truth(scene, rays, light_size),
        [&](const Pixel &pixel) {
            return area_answer(edge, pixel, light_size);
        },
        strata_deviation(rays, 4), true, report);
    double half = AxisKernel(scene.run.step, scene.run.settings).half_width();
    compare(
        edge, footprint_truth(scene, rays),
        [&](const Pixel &pixel) { return footprint_answer(edge, pixel, half); },
        strata_deviation(rays, 2), true, report);
    compare(
        edge, pcf_truth(scene),
        [&](const Pixel &pixel) { return pcf_answer(edge, pixel); }, 0, soft,
        report);
}
