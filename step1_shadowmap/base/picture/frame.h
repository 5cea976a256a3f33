// What the stages of a program share, from frame to frame.
#ifndef BASE_FRAME_H
#define BASE_FRAME_H

#include "step1_shadowmap/base/gl/target.h"        // Target, Targets
#include "step1_shadowmap/base/light/view.h"       // Views
#include "step1_shadowmap/base/picture/geometry.h" // Geometry
#include "step1_shadowmap/base/picture/settings.h" // BaseSettings
#include "step1_shadowmap/base/system/die.h"       // IF_LINKED

enum { TECHNIQUES_MAX = 24 };

// How the picture uses what it looks up; from this base/leave_out derives what
// cannot change a pixel. All zero: nothing is known.
typedef struct Lookups {
    int reach;     // texels that a lookup reads to each side, one for rounding
    bool anywhere; // it reads any texel of a layer that it reads at all
    // It compares the receiver, moved towards the light by these (see
    // bias.glsl), with each depth by itself: a depth behind all receivers says
    // "lit", as the empty map does.
    bool compares;
    double bias, slope_bias;
    // It compares the receiver with depths, or with a mean of depths, that lie
    // in a square of kernel x kernel texels around it, and rounding changes t
    // there by no more than this. 0: it compares with others.
    int kernel;
    double rounding;
    // It bounds the light by the variance of depths, whose places have this
    // variance around the receiver's, in square texels. 0: it does not.
    double spread;
} Lookups;

typedef struct Frame {
    BaseSettings settings;
    OptionTable options[OPTION_TABLES];
    Scene scene;
    Views views;
    Geometry geometry;
    Shaders shaders;
    Targets targets;
    Lookups lookups;
    bool technique[TECHNIQUES_MAX]; // of the table's, who takes part
    // Shader files that stand for a visibility() where nothing is looked up;
    // NULL: something is.
    const char *const *visibility;
    bool looks_up;    // the picture looks maps up, now or in a later frame
    bool changes;     // later frames may show something else
    GLuint empty_vao; // for passes that cover the whole viewport
    // In the frame after the last, which draws the maps alone and all of them:
    // the directory of --dump. Else NULL.
    const char *dump;
} Frame;

// A target for the light's views in this format; the caller fills in the rest.
Target frame_map(const Frame *frame, const char *pass, GLenum format,
                 Sampling sampling);

// Draws a triangle that covers each wanted layer of the target, with a program
// that reads single texels of what the target reads: it is `map` there, on unit
// 0, at far depth outside; and `layer` is the layer.
void frame_filter(const Frame *frame, Program *program, Target *target);

// base/measure takes the time of passes.

// A frame begins, with what is planned before its first pass.
IF_LINKED void frame_start(void);

// The passes since the last call, or since the frame's start, are done: notes
// their time and what they touched under this name. Nothing if all that they
// draw are maps that the picture does not look up.
void frame_lap(Frame *frame, const char *name);

// What the last frame took; 0: nobody knows.
IF_LINKED double frame_milliseconds(void);

#endif
