// The check `plan`: the picture of --show plan against the pixels that have to
// look a map up.
#ifndef ORACLE_SHOW_PLAN_H
#define ORACLE_SHOW_PLAN_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"

// Grey, orange or blue where no, one or two maps say how much light arrives:
// none where the surface faces away or is outside, two where one layer hands
// over to the next. Or grey everywhere, if `none` is to be looked up. `most` is
// the most lookups that a pixel needs: one in a hundred has to.
void check_show_plan(const Run &run, bool none, int most, Report &report);

#endif
