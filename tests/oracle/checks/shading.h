// The check `shading`: the picture from what it was made of.
#ifndef ORACLE_SHADING_H
#define ORACLE_SHADING_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/rays/rays.h"
#include "tests/oracle/lib/verdict.h"

// image.exr, made with --show shaded, from position, normal and visibility:
// albedo (ambient + radiance N.L visibility falloff).
void check_shading(const Run &run, const Scene &scene, const RayScene &rays,
                   double extent, Report &report);

#endif
