// Where in the light's maps the picture looks: found from the scene and the
// views alone. Conservative: what may be looked up is.
#ifndef BASE_RECEIVERS_H
#define BASE_RECEIVERS_H

#include "step1_shadowmap/base/light/view.h" // Views

// Finds the receivers: the parts of surfaces that are in the picture, of so
// many pixels, in front of the light or not known to face away, and in the map.
// Sets each layer's `looked_up` to the texels that they lie in, and some around
// them for rounding, and gives the largest t of a receiver, or somewhat more.
void receivers_find(Views *views, const Scene *scene, const int picture[2],
                    double deepest[]);

#endif
