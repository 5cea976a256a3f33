// The pieces of the check `rays`.
#ifndef ORACLE_RAY_CHECKS_H
#define ORACLE_RAY_CHECKS_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/rays/ray_compare.h"
#include "tests/oracle/rays/rays.h"
#include "tests/oracle/lib/verdict.h"

// Whether surfaces that the depth test cannot tell apart count as one.
enum class DepthTest { EXACT, ROUNDED };

// The map's depths, along rays through its texel centres.
RayComparison compare_ray_depths(const Run &run, const RayScene &rays,
                                 double extent, int layer, DepthTest test,
                                 double &worst_rounding);

// The same, judged; the depth test is taken as exact.
void check_ray_depths(const Run &run, const RayScene &rays, double extent,
                      int layer, Report &report);

// With --msaa: each sample against the ray through its place. Its depth is one
// that the surface there has in the texel.
void check_sample_depths(const Run &run, const RayScene &rays, double extent,
                         int layer, Report &report);

// position.exr against rays from the camera through the pixel centres.
void check_ray_positions(const Run &run, const Scene &scene,
                         const RayScene &rays, double extent, Report &report);

// visibility.exr against exact hard visibility, away from shadow edges.
void check_ray_visibility(const Run &run, const Scene &scene,
                          const RayScene &rays, double extent, Report &report);

// What share of something is expected.
struct Share {
    double least = 0, most = 1;

    bool asked() const
    {
        return least > 0 || most < 1;
    }
    // No share of nothing is right.
    bool holds(size_t part, size_t all) const
    {
        double share = double(part) / double(all);
        return all > 0 && share >= least && share <= most;
    }
};

// Of the pixels that rays say are lit, how many are dark; of those that they
// say are in shadow, how many are not, however near the occluder is. What is
// not asked for is not reported.
struct BiasShares {
    Share acne, lost;
};

void check_bias(const Run &run, const Scene &scene, const RayScene &rays,
                double extent, const BiasShares &shares, Report &report);

// The ray through u, v of the map. A distance along it is a depth t, from
// t = `start` on (Embree needs it to begin before what it should hit).
Ray map_ray(const MapView &view, double u, double v, double start);

// Whether something is before the near plane of a parallel light on such a ray:
// it casts from there, at depth 0.
bool before_near(const MapView &view, const RayScene &rays, const Ray &ray,
                 double start);

#endif
