// What a step can do besides its lesson: one folder under its techniques/ each.
// The lesson knows none of them. A program's own table of them (in its
// techniques/table.c) takes the place of an empty one where it is linked.
#ifndef BASE_TECHNIQUE_H
#define BASE_TECHNIQUE_H

#include "step1_shadowmap/base/picture/frame.h" // Frame

typedef struct Picture Picture;

// Functions that a technique does not need are NULL; it needs `prepare`.
typedef struct Technique {
    const Option *options; // or NULL: none; and what they are read into
    void *settings;
    // Refuses (status 2) options that contradict each other. May choose for
    // those that nobody gave.
    void (*check)(Frame *frame);
    // Whether it was asked for: only then the functions below are called. Puts
    // its shaders in the place of others (gl_put_instead) and says how the
    // picture looks the map up. The scene is there, and no stage yet.
    bool (*prepare)(Frame *frame);
    // Adds its targets. Those of the lesson are there: others may take their
    // place (target_take_place), and picture->map may become another one.
    void (*create)(Frame *frame, Picture *picture);
    void (*before)(const Frame *frame); // draws, before the lesson's passes
    void (*after)(const Frame *frame);  // and after them, before the picture
    const char *pass; // what --bench counts the time of `after` under
    // Sets the uniforms of its lookups. The picture's program is in use.
    void (*look)(const Frame *frame, GLuint program);
    // Draws the scene in another way than as it is rasterised, with that
    // program.
    void (*shade)(const Frame *frame, const Picture *picture);
} Technique;

// All that this program has, in the order of --help; NULL at the end.
extern const Technique *const techniques[];

// Joins their options to the tables from this number on.
void techniques_join(OptionTable tables[], int count);

// Each calls these functions of all techniques in their order; `check` and
// `prepare` from the last to the first, as later steps' choose for earlier ones
// and put their shaders first.
void techniques_check(Frame *frame);
void techniques_prepare(Frame *frame);
void techniques_create(Frame *frame, Picture *picture);
void techniques_before(const Frame *frame);
void techniques_after(Frame *frame);
void techniques_look(const Frame *frame, GLuint program);

// False: none shades.
bool techniques_shade(const Frame *frame, const Picture *picture);

#endif
