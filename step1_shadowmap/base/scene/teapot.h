// The Utah teapot's control points: Martin Newell's data of 1975 as widely
// published, with the lid tip at height 3.15 and with the bottom that others
// added later (the rows at heights 0.075 and 0). Newell's axes: z is up, the
// spout towards +x. Only numbers; mesh.c makes triangles of them.
#ifndef BASE_TEAPOT_H
#define BASE_TEAPOT_H

#include <stdbool.h>
#include <stddef.h> // size_t

// The lid tip, and with it the highest point of the surface.
static const double TEAPOT_HEIGHT = 3.15;

// Four control points per row. Four consecutive rows make a bicubic patch, and
// the next patch begins with the row that the one before ended with: that is
// why neighbours meet exactly. Rows run so that (along the row) x (to the next
// row) points out of the teapot.
static const double TEAPOT_ROWS[][4][3] = {
    // 0: the rim from its inner edge outwards; each row goes from +x to -y
    {{1.4, 0, 2.4}, {1.4, -0.784, 2.4}, {0.784, -1.4, 2.4}, {0, -1.4, 2.4}},
    {{1.3375, 0, 2.53125},
     {1.3375, -0.749, 2.53125},
     {0.749, -1.3375, 2.53125},
     {0, -1.3375, 2.53125}},
    {{1.4375, 0, 2.53125},
     {1.4375, -0.805, 2.53125},
     {0.805, -1.4375, 2.53125},
     {0, -1.4375, 2.53125}},
    // 3: the body, downwards
    {{1.5, 0, 2.4}, {1.5, -0.84, 2.4}, {0.84, -1.5, 2.4}, {0, -1.5, 2.4}},
    {{1.75, 0, 1.875},
     {1.75, -0.98, 1.875},
     {0.98, -1.75, 1.875},
     {0, -1.75, 1.875}},
    {{2, 0, 1.35}, {2, -1.12, 1.35}, {1.12, -2, 1.35}, {0, -2, 1.35}},
    // 6: the lower body
    {{2, 0, 0.9}, {2, -1.12, 0.9}, {1.12, -2, 0.9}, {0, -2, 0.9}},
    {{2, 0, 0.45}, {2, -1.12, 0.45}, {1.12, -2, 0.45}, {0, -2, 0.45}},
    {{1.5, 0, 0.225},
     {1.5, -0.84, 0.225},
     {0.84, -1.5, 0.225},
     {0, -1.5, 0.225}},
    // 9: the bottom, inwards to its centre
    {{1.5, 0, 0.15}, {1.5, -0.84, 0.15}, {0.84, -1.5, 0.15}, {0, -1.5, 0.15}},
    {{1.5, 0, 0.075},
     {1.5, -0.84, 0.075},
     {0.84, -1.5, 0.075},
     {0, -1.5, 0.075}},
    {{1.425, 0, 0}, {1.425, -0.798, 0}, {0.798, -1.425, 0}, {0, -1.425, 0}},
    {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
    // 13: the lid's knob from its tip; each row goes from +x to -y
    {{0, 0, 3.15}, {0, 0, 3.15}, {0, 0, 3.15}, {0, 0, 3.15}},
    {{0.8, 0, 3.15}, {0.8, -0.45, 3.15}, {0.45, -0.8, 3.15}, {0, -0.8, 3.15}},
    {{0, 0, 2.85}, {0, 0, 2.85}, {0, 0, 2.85}, {0, 0, 2.85}},
    // 16: the lid below the knob, outwards
    {{0.2, 0, 2.7}, {0.2, -0.112, 2.7}, {0.112, -0.2, 2.7}, {0, -0.2, 2.7}},
    {{0.4, 0, 2.55}, {0.4, -0.224, 2.55}, {0.224, -0.4, 2.55}, {0, -0.4, 2.55}},
    {{1.3, 0, 2.55}, {1.3, -0.728, 2.55}, {0.728, -1.3, 2.55}, {0, -1.3, 2.55}},
    {{1.3, 0, 2.4}, {1.3, -0.728, 2.4}, {0.728, -1.3, 2.4}, {0, -1.3, 2.4}},
    // 20: the handle from the body's upper end; each row goes from the inside
    // of its bend over the -y side to the outside
    {{-1.6, 0, 2.025},
     {-1.6, -0.3, 2.025},
     {-1.5, -0.3, 2.25},
     {-1.5, 0, 2.25}},
    {{-2.3, 0, 2.025},
     {-2.3, -0.3, 2.025},
     {-2.5, -0.3, 2.25},
     {-2.5, 0, 2.25}},
    {{-2.7, 0, 2.025}, {-2.7, -0.3, 2.025}, {-3, -0.3, 2.25}, {-3, 0, 2.25}},
    // 23: the handle's lower half, back to the body
    {{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3, -0.3, 1.8}, {-3, 0, 1.8}},
    {{-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3, -0.3, 1.35}, {-3, 0, 1.35}},
    {{-2.5, 0, 1.125},
     {-2.5, -0.3, 1.125},
     {-2.65, -0.3, 0.9375},
     {-2.65, 0, 0.9375}},
    {{-2, 0, 0.9}, {-2, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}},
    // 27: the spout from the body; each row goes from its upper side over the
    // -y side to its lower side
    {{1.7, 0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}},
    {{2.6, 0, 1.425},
     {2.6, -0.66, 1.425},
     {3.1, -0.66, 0.825},
     {3.1, 0, 0.825}},
    {{2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0, 2.025}},
    // 30: the spout's tip, over its lip and a little way back inside
    {{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}},
    {{2.8, 0, 2.475},
     {2.8, -0.25, 2.475},
     {3.525, -0.25, 2.49375},
     {3.525, 0, 2.49375}},
    {{2.9, 0, 2.475},
     {2.9, -0.15, 2.475},
     {3.45, -0.15, 2.5125},
     {3.45, 0, 2.5125}},
    {{2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}},
};

// The rows hold only the part with y <= 0, and of a surface of revolution only
// the quarter with x >= 0 as well; the rest of the usual 32 patches are mirror
// images of these ten.
typedef struct TeapotPatch {
    size_t first_row; // of four in TEAPOT_ROWS
    bool quarter;     // mirrored in x too, not only in y
} TeapotPatch;

enum { TEAPOT_PATCH_COUNT = 10 };

static const TeapotPatch TEAPOT_PATCHES[TEAPOT_PATCH_COUNT] = {
    {0, true},                // rim
    {3, true},   {6, true},   // body
    {9, true},                // bottom
    {13, true},  {16, true},  // lid
    {20, false}, {23, false}, // handle
    {27, false}, {30, false}, // spout
};

#endif
