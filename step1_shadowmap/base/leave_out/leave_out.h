// What no pixel of the picture needs is not drawn. From the scene and the views
// alone follows where the picture looks its maps up; from there this walks back
// over the targets that the passes read, each wider by what its pass reads
// around, to the objects that are drawn into the first one. It is conservative:
// what may be needed is drawn. Nothing that it leaves out changes a pixel.
#ifndef BASE_LEAVE_OUT_H
#define BASE_LEAVE_OUT_H

#include <stdint.h> // uint64_t

#include "step1_shadowmap/base/run/extras.h" // Frame

typedef struct LeaveOut {
    bool plan;           // print what is left out, and why
    bool keep_all;       // leave nothing out
    bool redraw;         // draw the map in every frame
    const char *shadows; // on or off
    bool printed;        // the plan
    bool fitted;         // the views, for a scene with this stamp
    uint64_t scene;
    bool decided; // what is wanted of these views
    bool whole;   // everything is drawn
    bool lookups; // some layer is looked up in this frame
    const char *why;
    int in_picture; // objects
    struct {
        double deepest; // t of a receiver, or somewhat more
        int objects;    // that are drawn
        int behind;     // and that are not, being behind all receivers
        // What the texels are made from, and this and what was looked up when
        // they were last drawn; 0: never. What is filtered of them grows with
        // what is looked up, so it is as new as they are.
        uint64_t made_from, drawn_from;
        Rect drawn_for;
    } layer[VIEW_MAX_LAYERS];
} LeaveOut;

extern const Option leave_out_list[];
extern const ShowMode leave_out_shows[];

// What --plan prints: each pass, whether it is kept, and why.
void leave_out_print(const LeaveOut *left, const Frame *frame);

#endif
