// What other techniques of step 5 put in the place of the lesson's visibility.
#ifndef STEP5_GUARDED_H
#define STEP5_GUARDED_H

// In place of visibility.glsl: how moments are merged, the guard, a bias of the
// variance and the bound, in a file each. Techniques put others in the place of
// these.
extern const char *const guarded_visibility[];

// Lookups that --soft averages for a pixel: POISSON_TAPS of poisson_disc.glsl.
enum { GUARDED_SOFT_TAPS = 32 };

#endif
