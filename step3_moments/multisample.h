// --msaa: several samples per texel while the map is drawn, then their moments.
#ifndef STEP3_MULTISAMPLE_H
#define STEP3_MULTISAMPLE_H

#include "step1_shadowmap/shadow_map.h" // ShadowMap

// What one layer of a map is drawn into, before it is resolved.
typedef struct Multisample {
    Program resolve;
    GLuint texture; // of one layer, `samples` per texel
    GLuint depth_buffer;
    GLuint framebuffer;
    GLuint empty_vao;
    GLenum format;
    int samples; // per texel; 0: none of this exists
    size_t bytes;
} Multisample;

// For maps of this size and format, resolved by the program, which it owns from
// here on: resolve.frag behind a merge and a store shader (see moments.h).
// Refuses (status 2) a number of samples that this driver does not have.
Multisample multisample_create(Program resolve, int samples, GLenum format,
                               int width, int height);

// As shadow_map_draw, with the map's program.
Touched multisample_draw(const Multisample *multisample, const ShadowMap *map,
                         const Geometry *geometry, const MapPlan *plan);

// Draws every layer once more and writes sample S of layer L as
// directory/samples.L.S.exr, and as sample_positions.exr, of one row, where
// each lies in a texel: x and y in [0, 1], y upwards.
void multisample_dump(const Multisample *multisample, const ShadowMap *map,
                      const Geometry *geometry, const MapPlan *plan,
                      const char *directory);

// Compiles the shaders again; see gl_program_reload.
bool multisample_reload(Multisample *multisample);

void multisample_destroy(Multisample *multisample);

#endif
