#include "tests/oracle/closed/penumbra.h"

#include <algorithm> // count_if, max, min, sort
#include <cmath>     // abs
#include <vector>

#include "tests/oracle/dump/light.h"
#include "tests/oracle/dump/projection.h"

// A disc's area left of x, from its middle in units of its radius, is a tenth
// at -0.687: the distance from a tenth to nine tenths, in diameters.
static constexpr double DISC_PROFILE = 0.687;
static constexpr double TOLERANCE = 0.25;
static constexpr double LEAST_TEXELS = 4;
static constexpr size_t LEAST_SAMPLES = 200;

namespace
{

// A mesh_plane of the scene, relative to the origin.
struct Rectangle {
    glm::dvec3 centre, half_x, half_z, normal;
};

// A point of the floor as seen from the light past the rectangle.
struct Sample {
    double out;    // across the nearest side, world units on the floor
    double corner; // to the next corner along that side, likewise
    double receiver, occluder; // distances, see Light
    double visibility;
};

} // namespace

static Rectangle rectangle_of(const Run &run, const SceneTable &table,
                              const std::string &name)
{
    const Object *object = table.find(name);
    if (object == nullptr)
        throw BadInput("the scene has no " + name);
    auto column = [&](int k) {
        return glm::dvec3(object->transform[0][k], object->transform[1][k],
                          object->transform[2][k]);
    };
    Rectangle r{column(3) - run.origin, 0.5 * column(0), 0.5 * column(2), {}};
    r.normal = glm::normalize(glm::cross(r.half_x, r.half_z));
    return r;
}

// Where the ray from a point to the light passes the rectangle's plane.
static glm::dvec3 passes(const Rectangle &plane, const MapView &view,
                         const glm::dvec3 &point)
{
    glm::dvec3 ray = towards_light(view, point);
    double part = glm::dot(plane.normal, plane.centre - point) /
                  glm::dot(plane.normal, ray);
    return point + part * ray;
}

// Along the light's axis, which is the rectangle's normal.
static double distance_to(const MapView &view, const Rectangle &plane,
                          const glm::dvec3 &point)
{
    if (view.parallel())
        return view.near + (view.far - view.near) * map_point(view, point).z;
    return std::abs(glm::dot(plane.normal, point - view.position));
}

static Sample sample_of(const Rectangle &plane, const MapView &view,
                        const Receiver &r)
{
    glm::dvec3 at = passes(plane, view, r.position), from = at - plane.centre;
    Sample sample{0, 0, distance_to(view, plane, r.position),
                  distance_to(view, plane, at), r.visibility};
    double grown = view.parallel() ? 1 : sample.receiver / sample.occluder;
    double x = glm::length(plane.half_x), z = glm::length(plane.half_z);
    double over_x = std::abs(glm::dot(from, plane.half_x)) / x - x;
    double over_z = std::abs(glm::dot(from, plane.half_z)) / z - z;
    sample.out = grown * std::max(over_x, over_z);
    sample.corner = -grown * std::min(over_x, over_z);
    return sample;
}

// The floor's pixels that the light's rays reach past a rectangle.
static std::vector<Sample> samples_of(const Run &run, const SceneTable &table,
                                      const std::string &name)
{
    Rectangle plane = rectangle_of(run, table, name);
    Rectangle floor = rectangle_of(run, table, "floor");
    double extent = scene_extent(table.scene, run.origin);
    Receivers receivers(run);
    std::vector<Sample> samples;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown ||
                std::abs(glm::dot(floor.normal, r.position - floor.centre)) >
                    1e-5 * extent)
                continue;
            const MapView &view = run.views[size_t(r.layer)];
            if (facing(r, view) == Facing::TOWARDS && inside_map(r))
                samples.push_back(sample_of(plane, view, r));
        }
    if (samples.empty())
        throw BadInput("the picture shows no floor in the light");
    return samples;
}

static double width_of(const Run &run, double receiver, double occluder)
{
    double gap = run.settings.penumbra_scale * run.settings.light_size *
                 (receiver - occluder);
    return run.views[0].parallel() ? gap : gap / occluder;
}

// How far out visibility is a share: as many of the samples, sorted by how far
// out they are, are darker as lie further in.
static double reached(const std::vector<Sample> &sorted, double share)
{
    auto darker = [share](const Sample &s) { return s.visibility < share; };
    auto count = std::count_if(sorted.begin(), sorted.end(), darker);
    count = std::min<long>(count, long(sorted.size()) - 1);
    return sorted[size_t(count)].out;
}

// Texels per world unit on the floor, in the middle of the map.
static double texels_per_unit(const Run &run, double receiver)
{
    const MapView &view = run.views[0];
    glm::dvec3 across =
        glm::dvec3(view.rows[0]) - 0.5 * glm::dvec3(view.rows[3]);
    double texels = glm::length(across) * view.width / run.settings.downsample;
    return view.parallel() ? texels : texels / receiver;
}

void check_penumbra(const Run &run, const SceneTable &table, Report &report)
{
    std::vector<Sample> all = samples_of(run, table, "occluder"), near;
    double receiver = all[0].receiver, occluder = all[0].occluder;
    double width = width_of(run, receiver, occluder);
    for (const Sample &s : all)
        if (std::abs(s.out) < 1.2 * width && s.corner > 1.5 * width)
            near.push_back(s);
    std::sort(near.begin(), near.end(),
              [](const Sample &a, const Sample &b) { return a.out < b.out; });
    const MapView &view = run.views[0];
    double texels = width * texels_per_unit(run, receiver);
    double largest = std::min(view.width, view.height) / 8.0;
    report.line(texels >= LEAST_TEXELS && texels < largest &&
                    near.size() >= LEAST_SAMPLES,
                "the penumbra can be measured",
                "%.3g texels of 4 to %.3g, %zu pixels", texels, largest,
                near.size());
    if (near.empty())
        return;
    double measured = reached(near, 0.9) - reached(near, 0.1);
    double ratio = measured / (DISC_PROFILE * width);
    report.line(std::abs(ratio - 1) <= TOLERANCE,
                "the penumbra's width is the light's",
                "%.4g of %.4g world units, gap %.4g", ratio * width, width,
                receiver - occluder);
}

void check_umbra(const Run &run, const SceneTable &table, Report &report)
{
    if (!run.settings.hybrid)
        throw BadInput("umbra needs --hybrid");
    size_t count = 0;
    double brightest = 0;
    for (const Sample &s : samples_of(run, table, "lower")) {
        double widest = width_of(run, s.receiver, run.views[0].near);
        if (s.out > -widest / 2 - 4 / texels_per_unit(run, s.receiver))
            continue;
        count++;
        brightest = std::max(brightest, s.visibility);
    }
    report.line(count >= LEAST_SAMPLES && brightest == 0,
                "no light bleeds under --hybrid",
                "brightest %.3g of %zu pixels", brightest, count);
}
