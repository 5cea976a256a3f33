// What a disc of taps promises whatever the scene.
#ifndef ORACLE_DISC_H
#define ORACLE_DISC_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"

// --pattern poisson against the same picture with --pattern grid, without
// splits: every visibility is a count of 32 taps; and where either is between
// 0 and 1 they are as light on average. Each turn of the disc is there with its
// opposite, so the taps have no mean offset, as the grid's have none: across a
// long edge both gain as much light as they lose. What is left is the taps'
// noise: a pixel's standard deviation is at most that of 32 coins.
void check_disc(const Run &disc, const Run &grid, Report &report);

#endif
