// Step 5, --deferred: first what each pixel shows, then its light. A pixel is
// shaded once, however many surfaces were drawn over it.
#ifndef STEP5_DEFERRED_H
#define STEP5_DEFERRED_H

#include "step1_shadowmap/base/picture/scene_draw.h" // SceneDraw

enum { DEFERRED_TEXTURES = 5 };

// Where the shading finds what a pixel shows.
const SceneSource *deferred_source(bool deferred);

// The G-buffer: position relative to the camera, normal and albedo, and where
// the picture's lookup needs the footprint the position's two derivatives. All
// are 32-bit floats. A position from the depth buffer would be cheaper to keep,
// but at view depth z its error is near 2^-24 z^2 / near, that of a stored
// float 2^-24 z: t, and with it the picture, would be another one.
typedef struct Deferred {
    Program program; // none: not deferred
    GLuint framebuffer;
    GLuint textures[DEFERRED_TEXTURES];
    int count; // of the textures
    GLuint empty_vao;
} Deferred;

// For a picture made with deferred_source(); shares its depth buffer, and adds
// to what it touches. Where it was not asked for, all zero.
Deferred deferred_create(bool asked_for, const BaseSettings *base,
                         SceneDraw *picture);

// As scene_draw; in two passes where it is deferred. The same picture to the
// last bit where the driver computes both alike.
void deferred_draw(const Deferred *deferred, const SceneDraw *picture,
                   const Scene *scene, const Geometry *geometry,
                   const Views *views, GLuint map);

bool deferred_reload(Deferred *deferred);

void deferred_destroy(Deferred *deferred);

#endif
