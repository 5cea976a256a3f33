// What a run does besides drawing a picture. Each of these has a room of its
// own; where the room is not there, its functions are NULL.
#ifndef BASE_EXTRAS_H
#define BASE_EXTRAS_H

#include "step1_shadowmap/base/picture/frame.h" // Frame
#include "step1_shadowmap/base/system/die.h"    // IF_LINKED

// base/leave_out: what no pixel needs is not drawn.

IF_LINKED OptionTable leave_out_options(BaseSettings *settings);

// Fits the views with room for the lookups, finds what of them the picture
// looks up, and says whether it looks anything up. Does nothing if since the
// last time neither the camera nor an object has moved. Refuses (status 2)
// options that contradict each other.
IF_LINKED void leave_out_look(Frame *frame);

// A frame begins: which layers are drawn in it, and what of them? Those that
// have changed since they were, which they are from here on; `anew`: all, for
// the shaders have changed. The first time this prints what --plan asks for.
IF_LINKED void leave_out_begin(Frame *frame, bool anew);

// Wants everything in every map, and no picture: for the files of --dump.
// False: there are no maps.
IF_LINKED bool leave_out_nothing(Frame *frame);

// base/measure: many frames, the times of their passes, and how a run was made.

IF_LINKED OptionTable bench_options(void);

// Refuses (status 2) options that contradict each other.
IF_LINKED void bench_check(Frame *frame);

// Whether there is a frame after so many. Moves for it what is to be moved;
// refuses (status 2) to move what the scene does not have.
IF_LINKED bool bench_next(Frame *frame, int drawn);

// --print-shader: prints the picture's program and exits.
IF_LINKED void measure_print_shader(const Frame *frame, const Program *program);

// Prints the times.
IF_LINKED void bench_print(void);

// Writes run.json into the directory of --dump: the options, the origin and the
// matrices in double, the OpenGL driver and the pass times.
IF_LINKED void measure_dump(const Frame *frame);

#endif
