// Step 4: the moments, filtered before anyone looks them up.
#ifndef STEP4_BLUR_H
#define STEP4_BLUR_H

#include "step1_shadowmap/base/options.h" // Option
#include "step1_shadowmap/shadow_map.h"   // ShadowMap

typedef struct BlurSettings {
    const char *kernel; // none, box, gaussian or binomial
    int radius;         // texels of the downsampled map
    int downsample;     // factor along each axis
} BlurSettings;

extern const Option blur_options[];

BlurSettings blur_settings(void);

// The weights of the kernel along one axis, 2 radius + 1 of them, which add up
// to 1 up to rounding. `name` is box (all equal), gaussian (standard deviation
// radius / 3, cut at the radius) or binomial (row 2 radius of Pascal's
// triangle; for radius 3 it is 1 6 15 20 15 6 1, over 64).
void blur_weights(const char *name, int radius, float weights[]);

// Refuses (status 2) a radius that contradicts the kernel or is wider than
// the map, and a factor that does not divide the map.
void blur_settings_check(const BlurSettings *settings, const int map_size[2],
                         const OptionTable tables[]);

// How many texels of the full map one filtered lookup reads to each side.
int blur_reach(const BlurSettings *settings);

// An array texture of the map's size over the factor, and what fills it.
typedef struct BlurTarget {
    GLuint texture;
    GLuint framebuffers[VIEW_MAX_LAYERS];
} BlurTarget;

typedef struct Blur {
    Program downsample_program; // none where the factor is 1
    Program blur_program;       // none where the radius is 0
    GLuint weights;             // 1D kernel, 2 radius + 1 texels
    GLuint empty_vao;
    BlurTarget small;      // downsampled
    BlurTarget horizontal; // blurred along u
    BlurTarget vertical;   // then along v
    int factor, radius;
    int width, height, layers; // of the result
    size_t bytes;              // of the textures that the filter needs
} Blur;

Blur blur_create(ShaderFiles files, const BlurSettings *settings,
                 const ShadowMap *moments, GLenum format);

// Filters every layer and returns the texture that holds the result: the
// moments themselves where there is nothing to do.
GLuint blur_apply(const Blur *blur, const ShadowMap *moments);

// Compiles the shaders again; see gl_program_reload.
bool blur_reload(Blur *blur);

void blur_destroy(Blur *blur);

#endif
