// Step 5, --deferred: first what each pixel shows, then its light. A pixel is
// shaded once, however many surfaces were drawn over it.
#ifndef STEP5_DEFERRED_H
#define STEP5_DEFERRED_H

#include "step1_shadowmap/base/picture/picture.h" // Picture

// Where the shading finds what a pixel shows.
const PictureSource *deferred_source(bool deferred);

// The G-buffer: position relative to the camera, normal and albedo, and where
// the picture's lookup needs the footprint the position's two derivatives. All
// are 32-bit floats. A position from the depth buffer would be cheaper to keep,
// but at view depth z its error is near 2^-24 z^2 / near, that of a stored
// float 2^-24 z: t, and with it the picture, would be another one.
typedef struct Deferred {
    Target target;
    Program *program; // NULL: not deferred
    int count;        // of the textures
} Deferred;

// For a picture made with deferred_source(), whose depth buffer it shares.
// Where it was not asked for, a row in the plan alone.
void deferred_create(Deferred *deferred, Frame *frame, bool asked_for,
                     Picture *picture);

// As picture_draw; in two passes where it is deferred. The same picture to the
// last bit where the driver computes both alike.
void deferred_draw(Deferred *deferred, Picture *picture, const Frame *frame);

#endif
