// Closed forms of soft shadows, where rectangles and a floor are perpendicular
// to the light.
#ifndef ORACLE_PENUMBRA_H
#define ORACLE_PENUMBRA_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"
#include "tests/oracle/dump/scene_table.h"

// Scene edge, step 5 --soft: along the occluder's sides visibility goes from
// 0.1 to 0.9 over 0.687 of the penumbra's width, as a disc's covered area does,
// within a quarter. The width is light-size times the gap, under a spot or
// point light divided by the occluder's distance. A penumbra under 4 texels, or
// wider than the search, is no such thing: that fails.
void check_penumbra(const Run &run, const SceneTable &table, Report &report);

// Scene bleed, step 5 --hybrid: on the floor, deeper in the lower occluder's
// shadow than the widest disc reaches, visibility is 0.
void check_umbra(const Run &run, const SceneTable &table, Report &report);

#endif
