#include <algorithm> // max, min
#include <cmath>     // abs, INFINITY, pow, round

#include "tests/oracle/closed/matrix.h"
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/lib/rounding.h"

// Zhang's mix, with the program's choice of 3/4 logarithmic; the first split
// begins at a hundredth of the reach.
static double expected_end(size_t layer, size_t count, double reach)
{
    double near = reach / 100, part = double(layer + 1) / double(count);
    double logarithmic = near * std::pow(reach / near, part);
    double uniform = near + (reach - near) * part;
    return 0.75 * logarithmic + 0.25 * uniform;
}

static void check_distances(const Run &run, const SceneTable &table,
                            size_t layer, Report &report)
{
    const MapView &view = run.views[layer];
    double begin = layer > 0 ? run.views[layer - 1].handover : 0;
    double end =
        expected_end(layer, run.views.size(), table.scene.camera.reach);
    double handover = end - 0.1 * (end - begin);
    double off =
        std::max(std::abs(view.end - end), std::abs(view.handover - handover));
    report.line(off <= 1e-12 * end, "the split ends where Zhang says",
                "%.6g, handing over from %.6g, off by %.3g", view.end,
                view.handover, off);
}

// Texels to the border, along u and v, of what lies nearest to it.
static glm::dvec2 to_border(const MapView &view, const glm::dvec3 &point)
{
    glm::dvec2 map(map_point(view, point));
    return glm::min(map, 1.0 - map) * glm::dvec2(view.width, view.height) -
           view.border;
}

// The same of everything that casts, or of everything if nothing does.
static glm::dvec2 casters_to_border(const Run &run, const Scene &scene,
                                    const MapView &view)
{
    bool any = false;
    for (int i = 0; i < scene.object_count; i++)
        any = any || scene.objects[i].casts;
    glm::dvec2 least(INFINITY);
    for (int i = 0; i < scene.object_count; i++)
        if (scene.objects[i].casts || !any)
            for (const glm::dvec3 &p :
                 object_points(scene.objects[i], run.origin))
                least = glm::min(least, to_border(view, p));
    return least;
}

// Along u, and along v, the map holds inside its border either the eight
// corners of what the camera sees between two depths or all that casts: around
// that there is only light. The corners lie in the range of depths. The
// corners' ball is what makes the view as large however the camera turns, so it
// is tight for that, not for them.
static void check_slice(const Run &run, const SceneTable &table, size_t layer,
                        Report &report)
{
    const MapView &view = run.views[layer];
    PictureCamera camera(table.scene.camera, run.width, run.height);
    double begin = layer > 0 ? run.views[layer - 1].handover : 0;
    glm::dvec2 seen(INFINITY);
    bool deep = true;
    std::vector<glm::dvec3> corners;
    for (double depth : {begin, view.end})
        for (double x : {0.0, double(run.width)})
            for (double y : {0.0, double(run.height)}) {
                corners.push_back(depth * camera.ray(x, y));
                glm::dvec3 map = map_point(view, corners.back());
                seen = glm::min(seen, to_border(view, corners.back()));
                deep = deep && map.z >= 0 && map.z <= 1;
            }
    glm::dvec2 either =
        glm::max(seen, casters_to_border(run, table.scene, view));
    double least = std::min(either.x, either.y);
    report.line(least >= 0 && deep, "the split holds what is seen in it",
                "%.3g texels or more from the border, depths %s", least,
                deep ? "inside" : "outside");
    double widest = 0;
    for (const glm::dvec3 &a : corners)
        for (const glm::dvec3 &b : corners)
            widest = std::max(widest, glm::distance(a, b));
    int side = std::min(view.width, view.height);
    double held = (side - 2 * view.border) /
                  (view.width * glm::length(glm::dvec3(view.rows[0])));
    // The ball through eight corners is wider than their longest distance by
    // less than 1.16, the ratio for a regular tetrahedron being 1.22.
    // The depths have a margin on top, of an eighth in all.
    double most = 1.25 * widest * (1 + 3.0 / side);
    double range = view.far - view.near;
    report.line(held <= most && range <= 1.15 * most, "the split is tight",
                "holds %.6g, %.6g deep, widest between corners %.6g", held,
                range, widest);
}

// Texels are square, and the world's origin is a whole number of them from the
// middle of the map: so they are the same ones wherever the camera is.
static void check_snapped(const Run &run, size_t layer, Report &report)
{
    const MapView &view = run.views[layer];
    glm::dvec3 zero = map_point(view, -run.origin);
    double texel = 1 / (view.width * glm::length(glm::dvec3(view.rows[0])));
    double high = 1 / (view.height * glm::length(glm::dvec3(view.rows[1])));
    double x = (zero.x - 0.5) * view.width, y = (zero.y - 0.5) * view.height;
    double off =
        std::max(std::abs(x - std::round(x)), std::abs(y - std::round(y)));
    double size = 1 + std::abs(x) + std::abs(y);
    report.line(off <= 1e-12 * size && std::abs(high / texel - 1) <= 1e-12,
                "texels are square and keep their places",
                "the world's origin is %.9g and %.9g texels from the middle", x,
                y);
}

void check_split(const Run &run, const SceneTable &table, int layer,
                 Report &report)
{
    check_distances(run, table, size_t(layer), report);
    check_slice(run, table, size_t(layer), report);
    check_snapped(run, size_t(layer), report);
}
