// The check `stability`: what a dump's numbers have lost, against what they may
// lose. Prints a table.
#ifndef ORACLE_STABILITY_H
#define ORACLE_STABILITY_H

#include "tests/oracle/dump/dump.h"

// CSV: quantity, how many values were compared and of how many, the error that
// is the largest part of its bound, that bound, their ratio, the part that this
// picture or a search for worse depths reaches (empty: it does not apply), how
// many values in all files are not finite, and with auto how far p is at most
// below the exact one, which is at least the lit share. Quantities, all
// compared with double precision:
//   receiver    step 1: t of each pixel, from its position
//   depth       step 1: each texel, against rays
//   visibility  step 2: each pixel, from its t and the map
//   variance    steps 3, 4: of each texel, from the depths under its filter
//   p           step 5: each pixel behind its mean whose bound is at most 0.1;
//               if there is none, the largest error of the others
void print_stability(const Run &run);

#endif
