// The pieces of the check `stage`: each recomputes one file of a dump from the
// stage's own input files.
#ifndef ORACLE_STAGE_H
#define ORACLE_STAGE_H

#include "tests/oracle/dump.h"
#include "tests/oracle/report.h"

// moments.L.exr: M2 is M1 squared and rounded once.
void check_moments(const Run &run, int layer, Report &report);

// blurred.L.exr from moments.L.exr, and its mean.
void check_blur(const Run &run, int layer, Report &report);

// visibility.exr from receiver, normal and the filtered map.
void check_visibility(const Run &run, Report &report);

#endif
