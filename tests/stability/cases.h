// The extreme cases of the formulas alone: a window of depths that is known,
// t exact, no picture.

#ifndef STABILITY_CASES_H
#define STABILITY_CASES_H

#include "tests/stability/formulas.h" // Fault

// Prints them all as CSV, the columns named in the first line. `fault` is
// planted in each.
void print_case_rows(Fault fault);

// A table of what `auto` leaves of p in full shadow, by gap and format.
void print_shadow_table(void);

#endif
