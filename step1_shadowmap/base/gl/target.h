// A target: the texture that one pass draws, layer by layer, and what is wanted
// of it. The stage says what the pass reads, and asks before it draws a layer;
// base/leave_out answers. Where nobody has asked leave_out, all is wanted.
#ifndef BASE_TARGET_H
#define BASE_TARGET_H

#include "step1_shadowmap/base/system/die.h" // IF_LINKED
#include "step1_shadowmap/base/gl/gl.h"      // Sampling

enum {
    TARGET_MAX_LAYERS = 8,
    TARGET_MAX_OUTPUTS = 7,
    TARGETS_MAX = 40,
    TARGET_EVERYWHERE = 1 << 20 // a reach: anywhere in the layer
};

typedef enum TargetKind {
    TARGET_LAYERS,  // a 2D array texture, one layer per view of the light
    TARGET_SAMPLES, // a multisampled 2D texture, which its layers share
    TARGET_PICTURE, // as many 2D textures as there are outputs
    TARGET_NOTHING  // no texture: the pass is only named in --plan
} TargetKind;

// How much a pass has to do at least: the texels, pixels or samples that it
// writes, and the bytes of these and of those that it reads of what was drawn
// before it; each once per draw. What a picture's pixels look up is not
// counted.
typedef struct Touched {
    size_t texels;
    size_t bytes;
} Touched;

// Texels of a map from low up to, not including, high: none where high is not
// above low along both axes.
typedef struct Rect {
    int low[2], high[2];
} Rect;

typedef struct Target Target;

struct Target {
    // The pass, for --plan: its name, and who does it or why there is none
    // (kind TARGET_NOTHING, or idle).
    const char *pass; // NULL: it has no row
    const char *why;
    bool idle;
    const char *file; // layer L is dumped as file.L.exr; NULL: it is not
    TargetKind kind;
    int width, height, layers;          // texels
    GLenum formats[TARGET_MAX_OUTPUTS]; // GL_NONE: no such output
    Sampling sampling;
    int samples;      // of each texel, TARGET_SAMPLES
    int levels;       // mip-map levels that the texture has room for; 0 is 1
    bool depth;       // it has a depth buffer,
    Target *depth_of; // or uses that of another target
    // The texture is that of another target, of which this is a mip-map level.
    Target *shares;
    int level;
    bool alias; // no pass draws it, see target_alias
    // What the pass reads: `scale` x `scale` texels of another target for one
    // of its own, and `reach` more to each side along u and v. NULL: the scene.
    Target *reads;
    int scale, reach[2];
    size_t read_bytes; // for each texel, besides
    int looked_up;     // texels that the picture reads to each side; 0: none

    // What base/leave_out decides of each layer: the texels that are wanted,
    // and whether they are drawn in this frame.
    struct {
        Rect wanted;
        bool draw;
    } layer[TARGET_MAX_LAYERS];

    // Made when it is first drawn.
    GLuint textures[TARGET_MAX_OUTPUTS];
    GLuint depth_buffer;
    GLuint framebuffers[TARGET_MAX_LAYERS];
    Touched touched; // see base/measure
};

// All targets of a program, each after those that it reads.
typedef struct Targets {
    Target *list[TARGETS_MAX];
    int count;
} Targets;

// Adds a target, which has to stay where it is. All of it is wanted from here
// on. Nothing of OpenGL is made yet.
void target_add(Targets *targets, Target *target);

// What these two stand on.
void target_insert(Targets *targets, int place, Target *target);
void target_want_all(Target *target);

// A map that a pass makes of each `factor` x `factor` texels of another one.
Target target_reading(Target *source, const char *pass, int factor);

// What another target is: the same texture, which no pass draws again.
Target target_alias(Target *of);

// The texels that the pass is to draw of a layer in this frame; NULL: nobody
// wants any of them. For a pass that draws into no framebuffer.
const Rect *target_wanted(Target *target, int layer);

// The same for one that does: binds the layer's framebuffer, with the viewport
// of the whole layer, limited to the wanted texels. False: nobody wants this
// layer.
bool target_begin(Target *target, int layer);

// The texture of its first output, undefined where it was not drawn.
GLuint target_texture(Target *target);

// base/measure counts a draw of these texels.
IF_LINKED void target_touch(Target *target, const Rect *wanted);

// base/leave_out limits all that is drawn and cleared to them; NULL: no longer.
IF_LINKED void target_limit(const Rect *wanted);

void targets_destroy(Targets *targets);

#endif
