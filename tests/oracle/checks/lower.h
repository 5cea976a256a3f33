// The check `lower`: Chebyshev's inequality itself, without its formula.
#ifndef ORACLE_LOWER_H
#define ORACLE_LOWER_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"

// Step 5 with bleed-reduction 0: p >= the weighted share of stored texels
// whose depth is at or behind the receiver, less what rounding can take.
void check_lower(const Run &run, Report &report);

#endif
