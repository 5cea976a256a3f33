// How each kind of light sees the scene: its views, which views_fit fits.
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

// Each sets the layers, their matrices and depths, and the light's position;
// origin, map size and border have been set.
void fit_directional(Views *views, const Scene *scene);
void fit_spot(Views *views, const Scene *scene);
void fit_point(Views *views, const Scene *scene);

// A directional light's views, each of a part of the way that the camera sees
// (Zhang 2006); `aspect` is the picture's width over its height.
void fit_splits(Views *views, const Scene *scene, double aspect, int count);

#endif
