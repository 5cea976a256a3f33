// What step 5 adds for a chain, from its own code.

#ifndef STABILITY_STEP5_GUARD_H
#define STABILITY_STEP5_GUARD_H

#include "tests/stability/formulas.h" // Chain

Guard guard_of_step5(const Chain *chain);

// Whether that is what bound.h asks for: each number at least the error that it
// is against, and no more than half of it more than guard_of() has.
bool step5_guards(const Chain *chain);

// The lesson's closed form in parts of what guard.c has for the same chain: of
// every radius and some factors the smallest and the largest part.
void print_closed_form(void);

#endif
