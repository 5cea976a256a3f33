// Step 1: the scene as the light sees it, in a texture.
#ifndef STEP1_SHADOW_MAP_H
#define STEP1_SHADOW_MAP_H

#include "step1_shadowmap/base/picture/geometry.h" // Geometry
#include "step1_shadowmap/base/gl/gl.h"            // ShaderFiles
#include "step1_shadowmap/base/system/options.h"   // Option
#include "step1_shadowmap/base/system/stopwatch.h" // Touched
#include "step1_shadowmap/base/light/view.h"       // Views
#include "step1_shadowmap/map_plan.h"              // MapPlan

// Against self-shadowing, for every step that compares depths.
typedef struct BiasSettings {
    double constant; // of the depth range
    double slope;    // of the depth change across half the comparison kernel
} BiasSettings;

extern const Option bias_options[];

BiasSettings bias_settings(void);

// Sets the uniforms of bias.glsl.
void bias_apply(const BiasSettings *settings, GLuint program);

// Nothing is looked up where a plane is alone and too much biased to shadow
// itself: compared with depths in this format, or with means of them about its
// own place, in a square of kernel x kernel texels.
void bias_plan(const BiasSettings *settings, Facts *facts, int kernel,
               GLenum format);

// What is behind all receivers is left out: where each depth is compared by
// itself it says "lit", as the empty map does. A bias must not push receivers
// behind it.
void bias_plan_behind(const BiasSettings *settings, Facts *facts);

typedef struct ShadowMap {
    Program program;
    GLuint texture; // 2D array, a layer per view
    GLuint depth_buffer;
    GLuint framebuffers[VIEW_MAX_LAYERS];
    GLenum format; // of the texture
    int width, height, layers;
    int channels;      // of the texture
    Sampling sampling; // of the texture
    size_t bytes;      // of the texture and the depth buffer
    Touched touched;   // by the last shadow_map_draw
} ShadowMap;

// The program that fills a map. Its fragment shader is light_depth.glsl and
// then these files (NULL at the end; fewer than PROGRAM_MAX_FILES): one with
// the formula of t, and last one that writes what the map keeps of
// map_depth(), t in [0, 1].
Program shadow_map_program(ShaderFiles files, const char *const shaders[]);

// Single texels; outside is far depth, 1.
extern const Sampling shadow_map_depths;

// A map of the given format, one layer per view, filled by the program, which
// it owns from here on.
ShadowMap shadow_map_create(Program program, const Views *views, GLenum format,
                            Sampling sampling);

// Draws what the plan says of each layer; what nothing covers of its texels is
// at far depth.
void shadow_map_draw(ShadowMap *map, const Geometry *geometry,
                     const MapPlan *plan);

// The same of one layer, drawn now or not, into whatever framebuffer is bound.
void shadow_map_draw_layer(const ShadowMap *map, int layer,
                           const Geometry *geometry, const MapPlan *plan);

// Draws every layer whole, for the picture may have needed less, and writes
// layer L as directory/depth.L.exr.
void shadow_map_dump(ShadowMap *map, const Geometry *geometry,
                     const MapPlan *plan, const char *directory);

// Compiles the shaders again (see gl_program_reload); what they drew is drawn
// anew.
bool shadow_map_reload(ShadowMap *map, MapPlan *plan);

void shadow_map_destroy(ShadowMap *map);

#endif
