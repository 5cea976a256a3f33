// How a parallel light sees the scene.
#ifndef BASE_LIGHT_VIEW_H
#define BASE_LIGHT_VIEW_H

#include "step1_shadowmap/base/light/view.h" // Views

// A parallel light's axes and the bounds of everything that casts along them,
// or of everything if nothing does; relative to the origin.
typedef struct LightFrame {
    double axes[3][3]; // right, up, direction: unit, in world axes
    double low[3], high[3];
} LightFrame;

void bound_casters(LightFrame *frame, const Scene *scene,
                   const double origin[3]);

// A parallel light's view, of all that casts.
void fit_directional(Views *views, const Scene *scene, const ViewsSize *size);

#endif
