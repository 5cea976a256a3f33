// What a step can do besides its lesson: one folder under its techniques/ each.
// The lesson knows none of them. A program's own table of them (in its
// techniques/table.c) takes the place of an empty one where it is linked.
#ifndef BASE_TECHNIQUE_H
#define BASE_TECHNIQUE_H

#include "step1_shadowmap/base/picture/frame.h" // Frame

typedef struct Technique {
    const Option *options; // and what they are read into
    void *settings;
    // Refuses (status 2) options that contradict each other. NULL: none do.
    void (*check)(const Frame *frame);
    // If the technique was asked for, puts its shaders in the place of others
    // (gl_put_instead) and says how the picture looks the map up. Called once
    // the scene is there, before a stage is created.
    void (*prepare)(Frame *frame);
} Technique;

// All that this program has, in the order of --help; NULL at the end.
extern const Technique *const techniques[];

#endif
