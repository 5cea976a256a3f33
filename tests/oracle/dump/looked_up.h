// The check `looked-up`: what run.json says is looked up of each layer, against
// the pixels that do.
#ifndef ORACLE_LOOKED_UP_H
#define ORACLE_LOOKED_UP_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"

// Every lookup is in its layer's rectangle; and all rectangles together have no
// more than `most` times the texels that are between the outermost lookups.
void check_looked_up(const Run &run, double most, Report &report);

#endif
