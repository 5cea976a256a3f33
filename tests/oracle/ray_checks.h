// The pieces of the check `rays`.
#ifndef ORACLE_RAY_CHECKS_H
#define ORACLE_RAY_CHECKS_H

#include "tests/oracle/dump.h"
#include "tests/oracle/rays.h"
#include "tests/oracle/report.h"

// The map's depths against parallel rays through its texel centres.
void check_ray_depths(const Run &run, const RayScene &rays, double extent,
                      int layer, Report &report);

// position.exr against rays from the camera through the pixel centres.
void check_ray_positions(const Run &run, const Scene &scene,
                         const RayScene &rays, double extent, Report &report);

// visibility.exr against exact hard visibility, away from shadow edges.
void check_ray_visibility(const Run &run, const Scene &scene,
                          const RayScene &rays, double extent, Report &report);

// The ray through u, v of the map. A distance along it is a depth t, from
// t = `start` on (Embree needs it to begin before what it should hit).
Ray map_ray(const MapView &view, double u, double v, double start);

// Whether something is before the near plane of a split on such a ray: it casts
// from there, at depth 0.
bool before_near(const MapView &view, const RayScene &rays, const Ray &ray,
                 double start);

#endif
