// What a step can do besides its lesson: one folder under its techniques/ each.
// The lesson knows none of them. A program's own table of them (in its
// techniques/table.c) takes the place of an empty one where it is linked.
#ifndef BASE_TECHNIQUE_H
#define BASE_TECHNIQUE_H

#include "step1_shadowmap/base/picture/picture.h" // Frame, Picture

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

// What they are made with.

// The value of an option, where the command line put it or as the settings had
// it. NULL: this program has no such option.
void *options_value(const OptionTable tables[], const char *name);

// Whether this program has a flag that is set, or a choice that is this one.
bool options_on(const OptionTable tables[], const char *flag);
bool options_is(const OptionTable tables[], const char *name,
                const char *choice);

// The value of an integer option that this program has.
int options_integer(const OptionTable tables[], const char *name);

// From here on other files (NULL at the end, static) stand in place of one, in
// every list that names it: so a technique takes the place of a lesson's
// shader. They may name that file too, and others in whose place some stand. If
// something stands in its place already, that stays.
void gl_put_instead(Shaders *shaders, const char *file,
                    const char *const files[]);

// From here on these definitions in GLSL stand in front of every program that
// is made: what a technique knows only at run time.
void gl_put_in_front(Shaders *shaders, const char *definitions);

// target_add before one that is there: where a technique has passes between.
void target_add_before(Targets *targets, Target *target, const Target *before);

// The target of a pass that has this name; NULL: there is none.
Target *targets_find(const Targets *targets, const char *pass);

// Bytes of one texel of all outputs, without depth.
size_t target_texel_bytes(const Target *target);

// Whether this driver has compute shaders (OpenGL 4.3).
static inline bool gl_has_compute(void)
{
    return GLAD_GL_VERSION_4_3;
}

// Whatever reads a target of the list reads another one of its size instead, of
// which it becomes an alias. Its own pass draws nothing any more.
void target_take_place(Target *target, Target *other);

#endif
