// The steps between same-weights PCF and the program, one substitution at a
// time: where a technique's error comes from.
#ifndef ORACLE_CHAIN_H
#define ORACLE_CHAIN_H

#include <vector>

#include "tests/oracle/truths/truth.h"

// In order; none for steps 1 and 2, whose same-weights PCF is what they do.
// Steps 3 and 4:
//   mean       ideal depths, filtered in double, the mean compared with t
// Step 5:
//   chebyshev  their bound, without a minimum variance and a reduction
//   floor      with the minimum variance and the variance bias
//   reduction  with the light-bleeding reduction
// Then, where the moments of the map are stored in floats:
//   format     every map rounded to nearest as it is stored
// What is left to the program is its rasteriser, its arithmetic, and a lookup
// that is not one bilinear tap.
std::vector<Truth> models_of(const TruthScene &scene);

#endif
