// Two runs with other cameras: what both maps cover has to be the same.
#ifndef ORACLE_OVERLAP_H
#define ORACLE_OVERLAP_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"

// The views of `other` lie whole texels away from those of `run` (checked
// here), else shadows would crawl. Then the texels that both cover hold the
// same depths up to what floats keep of positions relative to a camera: 4 units
// in the last place of 1, on 99.9 % of them (a vertex that moves by a rounding
// may carry an outline over a texel's centre). Empty texels and those before
// the near plane are left out.
void check_overlap(const Run &run, const Run &other, Report &report);

#endif
