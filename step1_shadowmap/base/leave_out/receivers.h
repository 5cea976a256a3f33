// Where in the light's maps the picture looks: found from the scene and the
// views alone. Conservative: what may be looked up is.
#ifndef BASE_RECEIVERS_H
#define BASE_RECEIVERS_H

#include "step1_shadowmap/base/gl/rect.h"    // Rect
#include "step1_shadowmap/base/light/view.h" // Views

// Receivers are the parts of surfaces that are in the picture, in front of the
// light or not known to face away, and in the map.
typedef struct LayerFacts {
    Rect looked_up; // the texels that receivers lie in, and some around them
                    // for rounding; empty: none does
    double deepest; // the largest t of a receiver, or somewhat more
} LayerFacts;

// Of each layer, for a picture of so many pixels.
void receivers_find(LayerFacts layers[], const Scene *scene, const Views *views,
                    const int picture[2]);

#endif
