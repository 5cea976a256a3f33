// Where all that a parallel light's map holds of what is looked up is one
// plane, which cannot shadow itself.
#ifndef BASE_FLAT_H
#define BASE_FLAT_H

#include "step1_shadowmap/base/leave_out/facts.h" // Facts

typedef struct Flat {
    double slope; // least change of t to the next texel, along the steepest way
    double error; // most that t, or where it is compared, may be off, in t
    double sine;  // of the least angle at which light meets the plane
} Flat;

// Whether lookups that read so many texels to each side of the receiver's find
// nothing but one parallelogram in each layer, in every texel, neither at the
// near nor at the far plane. False where nothing is to be left out, and where a
// later frame may see other things.
bool flat_everywhere(const Facts *facts, int reach, Flat *flat);

#endif
