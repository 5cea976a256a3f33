// The check `truths`: each truth on scenes where the answer is known by
// construction.
#ifndef ORACLE_TRUTH_CHECKS_H
#define ORACLE_TRUTH_CHECKS_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"
#include "tests/oracle/truths/truth.h"

// Every check that the run's scene and step have. Throws BadInput for a scene
// without any.
void check_truths(const Run &run, double rays, double light_size,
                  Report &report);

// Scene edge: hard, area, footprint and pcf have closed forms.
void check_edge_truths(const TruthScene &scene, double rays, double light_size,
                       Report &report);

// Surfaces perpendicular to the light: lower, with ties lit, is pcf.
void check_lower_is_pcf(const TruthScene &scene, Report &report);

#endif
