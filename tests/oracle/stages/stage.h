// The pieces of the check `stage`: each recomputes one file of a dump from the
// stage's own input files.
#ifndef ORACLE_STAGE_H
#define ORACLE_STAGE_H

#include <functional>

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/rays/rays.h"
#include "tests/oracle/lib/verdict.h"

// Where the format is that of 16-bit floats, all values are such: 11 bits, or
// a multiple of 2^-24.
void check_stored(const Picture &map, const Settings &settings,
                  const std::string &name, Report &report);

// moments.L.exr, or with --msaa each sample: M2 is the depth squared and
// rounded once; M1 is the depth, rounded where 16-bit floats store it.
void check_moments(const Run &run, int layer, Report &report);

// With --msaa: moments.L.exr is the mean of the samples.
void check_resolve(const Run &run, int layer, Report &report);

// With --slope-term, where the rays around a texel meet one triangle: M2 is the
// depth squared and the variance of its plane's depth across the texel.
void check_slope(const Run &run, const RayScene &rays, double extent, int layer,
                 Report &report);

// blurred.L.exr from moments.L.exr, and its mean.
void check_blur(const Run &run, int layer, Report &report);

// Calls `use` for each pixel with the visibility that it may have.
using UseExpected = std::function<void(const Receiver &, Interval)>;
void for_each_expected(const Run &run, const UseExpected &use);

// visibility.exr from receiver, normal and the filtered map.
void check_visibility(const Run &run, Report &report);

#endif
