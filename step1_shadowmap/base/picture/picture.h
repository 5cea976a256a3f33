// The picture: the scene seen by the camera, with the visibility of the light
// that a step's shader computes from its map.
#ifndef BASE_PICTURE_H
#define BASE_PICTURE_H

#include "step1_shadowmap/base/picture/frame.h" // Frame
#include "step1_shadowmap/base/system/die.h"    // IF_LINKED

// Outputs that techniques may write for --dump.
enum { PICTURE_FOOTPRINT = 5, PICTURE_HANDOVER = 6 };

typedef struct Picture {
    Target target;                 // the picture; with --dump further outputs
    Target *map;                   // is looked up
    const char *const *visibility; // the files that look it up
    Program *program;
    bool drawing;    // it is wanted in this frame
    Program *legend; // or NULL
} Picture;

// `visibility` lists the fragment shader files (NULL at the end) that define
// float visibility(Receiver) of what the map holds, with `constants` (see
// gl_program); they are compiled together with step 1's scene.frag. Where the
// picture looks nothing up they are left out: the visibility is 1 wherever a
// surface faces the light.
void picture_create(Picture *picture, Frame *frame, Target *map,
                    const char *constants, const char *const visibility[]);

// Begins a frame's picture: clears it, and uses its program, whose name this
// returns for the uniforms of visibility(). The map is the shader's shadow_map.
// Where no picture is wanted nothing is drawn from here on.
GLuint picture_begin(Picture *picture, Frame *frame);

// Draws the scene with that program, and then the legend.
void picture_draw(const Picture *picture, const Frame *frame);

void picture_write(const Picture *picture, const char *path);

// Writes receiver, position, normal, visibility and image (.exr) into the
// directory, and what techniques write; needs a picture that was made with
// --dump.
void picture_dump(const Picture *picture, const char *directory);

// base/legend has these; without it there is none. It says what the colours of
// a --show picture mean, over colour attachment 0 of the bound framebuffer.
IF_LINKED Program *legend_create(Frame *frame);
IF_LINKED void legend_draw(Program *legend, const Frame *frame);

// Where techniques take part: base/seams asks those of the program's table, and
// without it these are NULL. Joins their options to the tables from this number
// on.
IF_LINKED void techniques_join(OptionTable tables[], int count);

// Each calls these functions of all techniques in their order; `check` and
// `prepare` from the last to the first, as later steps' choose for earlier ones
// and put their shaders first.
IF_LINKED void techniques_check(Frame *frame);
IF_LINKED void techniques_prepare(Frame *frame);
IF_LINKED void techniques_create(Frame *frame, Picture *picture);
IF_LINKED void techniques_before(const Frame *frame);
IF_LINKED void techniques_after(Frame *frame);
IF_LINKED void techniques_look(const Frame *frame, GLuint program);

// False: none shades.
IF_LINKED bool techniques_shade(const Frame *frame, const Picture *picture);

#endif
