// The picture: the scene seen by the camera, with the visibility of the light
// that a step's shader computes from its map.
#ifndef BASE_SCENE_DRAW_H
#define BASE_SCENE_DRAW_H

#include "step1_shadowmap/base/leave_out/facts.h"  // Facts
#include "step1_shadowmap/base/picture/geometry.h" // Geometry
#include "step1_shadowmap/base/run/settings.h"     // BaseSettings
#include "step1_shadowmap/base/system/stopwatch.h" // Touched
#include "step1_shadowmap/base/light/view.h"       // Views

enum { SCENE_DRAW_OUTPUTS = 7 };

// The shader file with vec4 footprint(Receiver), for a visibility() that needs
// to know how far apart the pixels are in the map.
extern const char scene_draw_footprint[];

// Where the shading finds what a pixel shows: the vertex shader, the file that
// defines relative_position, viewer_normal() and albedo, and the one that
// defines to_right and to_above, which only footprint.glsl needs.
typedef struct SceneSource {
    const char *vertex;
    const char *surface;
    const char *steps;
} SceneSource;

// From the rasteriser, while the scene is drawn.
extern const SceneSource scene_source_drawn;

typedef struct SceneDraw {
    Program program;
    bool footprint; // the shaders ask for it
    GLuint framebuffer;
    GLuint depth_buffer;
    GLuint outputs[SCENE_DRAW_OUTPUTS]; // picture; with --dump the rest too
    GLenum buffers[SCENE_DRAW_OUTPUTS]; // their attachments, or GL_NONE
    bool shaded; // --show shaded: the scene has a background
    Legend legend;
    int width, height; // pixels
    Touched touched;   // by each frame
} SceneDraw;

// `visibility` lists the fragment shader files (NULL at the end) that define
// float visibility(Receiver); they are compiled together with step 1's
// scene.frag. Where the facts say that nothing is looked up they are left out:
// the visibility is 1 wherever a surface faces the light. Adds a row to the
// plan: whether derivatives across the screen are taken. With --dump the
// picture has the further outputs that scene_draw_dump writes.
SceneDraw scene_draw_create(const BaseSettings *settings, Facts *facts,
                            const char *const visibility[]);

// The same from another source.
SceneDraw scene_draw_create_from(const SceneSource *source,
                                 const BaseSettings *settings, Facts *facts,
                                 const char *const visibility[]);

// Draws one frame with `map` (a 2D array texture) as the shader's shadow_map.
void scene_draw(const SceneDraw *draw, const Scene *scene,
                const Geometry *geometry, const Views *views, GLuint map);

// What comes before the pixels of a frame, and after them: clears the picture
// and sets the program and its uniforms; draws the legend.
void scene_draw_begin(const SceneDraw *draw, const Scene *scene,
                      const Views *views, GLuint map);
void scene_draw_end(const SceneDraw *draw);

// Compiles the shaders again; see gl_program_reload.
bool scene_draw_reload(SceneDraw *draw);

// Writes the picture to --output, if there is one, and says that it and the
// files of --dump are written: it comes last.
void scene_draw_write(const SceneDraw *draw, const BaseSettings *settings);

// Writes receiver, position, normal, visibility and image (.exr) into the
// directory, footprint where the list has scene_draw_footprint, and handover
// where there are splits; needs a SceneDraw made with --dump.
void scene_draw_dump(const SceneDraw *draw, const char *directory);

void scene_draw_destroy(SceneDraw *draw);

#endif
