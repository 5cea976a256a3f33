#include <algorithm> // min, max
#include <cmath>     // ceil, floor

#include "tests/oracle/rays/ideal_map.h"
#include "tests/oracle/dump/light.h"
#include "tests/oracle/rays/own_plane.h"
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/rays/ray_checks.h"
#include "tests/oracle/lib/rounding.h"

namespace
{

enum class Truth { LIT, SHADOWED, APART };

struct Tally {
    size_t lit = 0, lit_wrong = 0, shadowed = 0, shadowed_wrong = 0, apart = 0;
    double darkest_lit = 1, brightest_shadowed = 0;
};

// Whether an occluder within the bias is one: APART, or as good as any other.
enum class Close { APART, COUNTS };

struct RayContext { // what does not change from pixel to pixel
    const Run &run;
    const RayScene &rays;
    const PictureCamera &camera;
    double extent;
    Close close;
};

} // namespace

// The filter's half width in map texels and 2 more, for what a rasterised
// silhouette may differ from an ideal one.
static int filter_reach(const Run &run)
{
    const Settings &s = run.settings;
    if (run.step <= 2)
        return (s.kernel - 1) / 2 + (s.bilinear ? 3 : 2);
    if (s.soft) // what the views have room for
        return int(run.views[0].border / 2) + 2;
    return int(std::ceil(s.downsample * (s.radius + 1.5) - 0.5)) + 2;
}

namespace
{

// What a texel says of a receiver.
struct TexelSays {
    bool lit = true, shadowed = true;
};

// A receiver before a map, and how far off its depth may be.
struct Compared {
    const MapView &view;
    const IdealMap &map;
    const Receiver &receiver;
    const OwnPlane &plane;
    double bias, rounding;

    // By the depth that the map may hold for the point (x, y), in texels: lit
    // where it is not nearer than the receiver's plane, shadowed where it is
    // nearer than the plane, and than the receiver, by more than the bias.
    void add(double x, double y, double depth, TexelSays &says) const
    {
        double u = x / map.width(), v = y / map.height();
        double own = stored_depth(view, u, v, plane.depth(u, v));
        double held = stored_depth(view, u, v, depth);
        double nearest = std::min(own, receiver.t);
        says.lit = says.lit && held >= own - rounding;
        says.shadowed = says.shadowed && held < nearest - bias - rounding;
    }

    // The rasteriser may have moved an outline over the texel's centre: then
    // all that is within that distance of it has to say the same.
    void add_texel(int x, int y, TexelSays &says) const
    {
        add(x + 0.5, y + 0.5, map.at(x, y), says);
        const std::array<double, 4> *around = map.around(x, y);
        for (size_t k = 0; around && k < 4; k++)
            add(x + 0.5 + IdealMap::SNAP * IdealMap::SNAP_X[k],
                y + 0.5 + IdealMap::SNAP * IdealMap::SNAP_Y[k], (*around)[k],
                says);
    }
};

} // namespace

// What all texels in reach say. Mixtures, and occluders within the bias, are
// APART.
static Truth texels_in_reach(const Compared &compared, int reach)
{
    const IdealMap &map = compared.map;
    int centre_x = int(std::floor(compared.receiver.u * map.width()));
    int centre_y = int(std::floor(compared.receiver.v * map.height()));
    TexelSays says;
    for (int y = centre_y - reach; y <= centre_y + reach; y++)
        for (int x = centre_x - reach; x <= centre_x + reach; x++) {
            compared.add_texel(x, y, says);
            if (!says.lit && !says.shadowed)
                return Truth::APART;
        }
    if (says.lit)
        return Truth::LIT;
    return says.shadowed ? Truth::SHADOWED : Truth::APART;
}

// Exact hard visibility: is anything between the receiver and the light?
static bool in_shadow(const RayContext &context, const Receiver &r,
                      const MapView &view, const glm::dvec3 &normal)
{
    // Off the surface by more than the position's and Embree's rounding.
    double lift = rounding_share(64) * context.extent;
    glm::dvec3 start = r.position + lift * normal;
    return context.rays.occluded({start, towards_light(view, start)},
                                 view.parallel() ? INFINITY : 1);
}

// The normal of the triangle seen through the pixel, towards the viewer; 0
// where the rays see none.
static glm::dvec3 true_normal(const RayContext &context, int x, int y)
{
    Ray ray{glm::dvec3(0), context.camera.ray(x + 0.5, y + 0.5)};
    Hit hit = context.rays.first(ray);
    return hit.found() ? normal_towards(context.rays.triangle(hit.triangle),
                                        -ray.direction)
                       : glm::dvec3(0);
}

static Truth truth_of(const RayContext &context, const Receiver &r,
                      const MapView &view, const IdealMap &map,
                      const glm::dvec3 &normal)
{
    OwnPlane plane(view, r.position, normal);
    const Settings &settings = context.run.settings;
    double bias = 0;
    if (context.run.step <= 4 && context.close == Close::APART)
        bias = total_bias(r, view, map.width() / settings.downsample,
                          map.height() / settings.downsample, settings.kernel,
                          settings)
                   .hi;
    // Of the position, as a depth, and of the plane's slope over the reach.
    double rounding =
        rounding_share(32) * depth_size(view, context.extent, r.t);
    Truth truth = texels_in_reach({view, map, r, plane, bias, rounding},
                                  filter_reach(context.run));
    bool dark = in_shadow(context, r, view, normal);
    bool same = dark ? truth == Truth::SHADOWED : truth == Truth::LIT;
    return same ? truth : Truth::APART;
}

static void count(Truth truth, double visibility, Tally &tally)
{
    if (truth == Truth::LIT) {
        tally.lit++;
        tally.lit_wrong += visibility >= 0.98 ? 0 : 1;
        tally.darkest_lit = std::min(tally.darkest_lit, visibility);
    } else if (truth == Truth::SHADOWED) {
        tally.shadowed++;
        tally.shadowed_wrong += visibility <= 0.02 ? 0 : 1;
        tally.brightest_shadowed =
            std::max(tally.brightest_shadowed, visibility);
    } else {
        tally.apart++;
    }
}

static void print(const Run &run, const Tally &t, Report &report)
{
    report.line(t.lit_wrong == 0, "lit by rays",
                "%zu of %zu pixels under 0.98, darkest %.3g", t.lit_wrong,
                t.lit, t.darkest_lit);
    // Step 5 bleeds light, whatever is done right.
    bool bleeds = run.step == 5 && !run.settings.hybrid;
    report.line(bleeds || t.shadowed_wrong == 0, "shadowed by rays",
                "%zu of %zu pixels over 0.02%s, brightest %.3g",
                t.shadowed_wrong, t.shadowed,
                bleeds ? " (light bleeding, not judged)" : "",
                t.brightest_shadowed);
    size_t all = t.lit + t.shadowed + t.apart;
    report.line(all == 0 || t.lit + t.shadowed > 0, "tested by rays",
                "%zu of %zu pixels, %zu at silhouettes counted apart",
                t.lit + t.shadowed, all, t.apart);
}

static Tally tally_of(const Run &run, const Scene &scene, const RayScene &rays,
                      double extent, Close close)
{
    PictureCamera camera(scene.camera, run.width, run.height);
    RayContext context{run, rays, camera, extent, close};
    Receivers receivers(run);
    std::vector<IdealMap> maps;
    for (const MapView &view : run.views)
        maps.emplace_back(view, rays);
    Tally tally;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown)
                continue;
            const MapView &view = run.views[size_t(r.layer)];
            glm::dvec3 normal = true_normal(context, x, y);
            // Grazing light: facets and the bias' own limit decide, not rays.
            // Outside a spot's cone it is dark, whatever the rays say.
            if (cosine_to_light(r.normal, view, r.position) < 0.1 ||
                cosine_to_light(normal, view, r.position) < 0.1 ||
                facing(r, view) != Facing::TOWARDS)
                continue;
            Truth truth =
                truth_of(context, r, view, maps[size_t(r.layer)], normal);
            if (r.share > 0) { // two splits are mixed: both have to know
                Receiver next = r.in_next();
                size_t layer = size_t(next.layer);
                Truth other = layer < maps.size()
                                  ? truth_of(context, next, run.views[layer],
                                             maps[layer], normal)
                                  : Truth::LIT;
                truth = other == truth ? truth : Truth::APART;
            }
            count(truth, r.visibility, tally);
        }
    return tally;
}

void check_ray_visibility(const Run &run, const Scene &scene,
                          const RayScene &rays, double extent, Report &report)
{
    print(run, tally_of(run, scene, rays, extent, Close::APART), report);
}

void check_bias(const Run &run, const Scene &scene, const RayScene &rays,
                double extent, const BiasShares &shares, Report &report)
{
    Tally t = tally_of(run, scene, rays, extent, Close::COUNTS);
    if (shares.acne.asked())
        report.line(shares.acne.holds(t.lit_wrong, t.lit), "acne",
                    "%zu of %zu lit pixels under 0.98, a share of %g .. %g",
                    t.lit_wrong, t.lit, shares.acne.least, shares.acne.most);
    if (shares.lost.asked())
        report.line(
            shares.lost.holds(t.shadowed_wrong, t.shadowed), "lost shadow",
            "%zu of %zu shadowed pixels over 0.02, a share of %g .. %g",
            t.shadowed_wrong, t.shadowed, shares.lost.least, shares.lost.most);
}
