// Step 4: the moments, filtered before anyone looks them up.
#ifndef STEP4_BLUR_H
#define STEP4_BLUR_H

#include "step1_shadowmap/base/system/options.h" // Option
#include "step3_moments/moments.h"               // MomentsMap
#include "step4_blur/mips.h"                     // Mips
#include "step4_blur/sat.h"                      // Sat

enum { BLUR_MAX_FILTERS = 3 };

typedef struct BlurSettings {
    const char *kernel;  // none, box, boxes, gaussian or binomial
    int radius;          // texels of the downsampled map
    const char *by;      // what blurs: auto, compute or fragments
    int downsample;      // factor along each axis
    bool mips;           // a mip-map chain of the result
    int anisotropy;      // most lookups for one pixel; with mips
    const char *sampler; // of the levels: explicit or hardware
    bool sat;            // the box from a summed-area table
    const char *sat_by;  // what sums it: auto, compute or fragments
} BlurSettings;

extern const Option blur_options[];

BlurSettings blur_settings(void);

// The weights of the kernel along one axis, one for each texel that it holds,
// which add up to 1 up to rounding. `name` is box or one of several boxes (all
// equal), gaussian (standard deviation radius / 3, cut at the radius) or
// binomial (row 2 radius of Pascal's triangle; for radius 3 it is 1 6 15 20 15
// 6 1, over 64).
void blur_weights(const char *name, const int sides[2], float weights[]);

// The radius of the kernel, 0 where there is none.
int blur_used_radius(const BlurSettings *settings);

// One of the filters that run one after the other along an axis: how many
// texels it holds before and after the one in its middle.
typedef struct BlurSides {
    int sides[2];
} BlurSides;

// How many there are, and which: one, the radius to both sides; of boxes
// three. These are as alike as can be, and hold 2 radius + 3 texels together,
// so that all three reach as far as the radius.
int blur_filters(const BlurSettings *settings,
                 BlurSides filters[BLUR_MAX_FILTERS]);

// Whether running boxes can blur with these settings.
bool blur_can_run(const BlurSettings *settings, const MomentsSettings *moments);

// Whether they do, and not fragments: as --blur-by says, or for a wide box.
// Refuses (status 2) compute shaders where the driver has none.
bool blur_runs(const BlurSettings *settings, const MomentsSettings *moments);

// Whether the texture unit chooses and blends the levels.
bool blur_uses_hardware(const BlurSettings *settings);

// Refuses (status 2) options that contradict each other or the moments, a
// radius that contradicts the kernel or is wider than the map, and a factor
// that does not divide the map.
void blur_check(const BlurSettings *settings, const MomentsSettings *moments,
                const BaseSettings *base, const OptionTable tables[]);

// How many texels of the full map one filtered lookup reads to each side.
int blur_reach(const BlurSettings *settings);

// An array texture of the map's size over the factor, and what fills it.
typedef struct BlurTarget {
    GLuint texture;
    GLuint framebuffers[VIEW_MAX_LAYERS];
} BlurTarget;

typedef struct Blur {
    Program downsample_program; // none where there is no small map
    bool running; // the blur is of running boxes in compute shaders
    BlurSides filters[BLUR_MAX_FILTERS]; // none where the radius is 0
    char *constants[BLUR_MAX_FILTERS];   // of each one's program
    Program blur_programs[BLUR_MAX_FILTERS];
    int filter_count;
    GLuint empty_vao;
    GLuint texel_sampler;  // for the passes: single texels of a map
    BlurTarget small;      // downsampled; with mips alone: copied
    BlurTarget horizontal; // blurred along u; with boxes taking turns
    BlurTarget vertical;   // then along v; the last one
    Mips mips;             // of the result
    Sat sat;               // in place of the blur
    int factor, radius;
    int anisotropy;
    bool hardware;             // the texture unit looks the levels up
    int width, height, layers; // of the result
    size_t bytes;              // of the textures that the filter needs
    Touched touched;           // by the last blur_apply
    GLuint result;             // the texture that the picture looks up
} Blur;

Blur blur_create(ShaderFiles files, const BlurSettings *settings,
                 const MomentsMap *moments_map);

// What of the map is drawn and filtered.
typedef struct BlurPlan {
    MapPlan map; // of the moments
    // By layer, the texels that each pass writes of its own target; the first
    // of the levels is the result. Empty where a layer is not filtered.
    Rect small[VIEW_MAX_LAYERS];
    Rect passes[2 * BLUR_MAX_FILTERS][VIEW_MAX_LAYERS]; // of the blur
    Rect levels[MIPS_MAX_LEVELS][VIEW_MAX_LAYERS];
} BlurPlan;

// bias_plan of the blurred map's means, where each is about its own place.
void blur_plan_bias(const BiasSettings *bias, Facts *facts,
                    const BlurSettings *settings,
                    const MomentsSettings *moments);

// Decides from the last pass back to the first, each wider by what the one
// after it reads around it, and then what is drawn of the moments (see
// map_plan_decide). Adds all their rows to the facts' plan.
void blur_plan_decide(BlurPlan *plan, Facts *facts,
                      const BlurSettings *settings,
                      const MomentsSettings *moments);

// The variance of the weights of a filtered texel, in texels of the full map;
// of a lookup that is the mean of them about the receiver's own place. 0: it
// may be another, or about another place.
double blur_spread(const BlurSettings *settings);

// Every texel of every layer, for the files of --dump.
BlurPlan blur_plan_whole(const BlurPlan *plan, const Blur *blur);

// What the filter touches in this frame, of texels of this format.
Touched blur_plan_touched(const BlurPlan *plan, const Blur *blur,
                          GLenum format);

// Filters the layers that are drawn in this frame. Where there is nothing to do
// the result is the moments themselves.
void blur_apply(Blur *blur, const MomentsMap *moments, const BlurPlan *plan);

enum { BLUR_MAX_SHADERS = 8 };

// The one of them that looks up a table's box.
extern const char blur_sat_lookup[];

// The shader files of a picture that looks the result up: those that define
// vec2 moments_at(Receiver), then `visibility`, which uses it, then NULL. What
// was not asked for is not among them. Up to BLUR_MAX_SHADERS with the NULL.
void blur_picture_shaders(const BlurSettings *settings,
                          const MomentsSettings *moments,
                          const char *visibility, const char *files[]);

// The coarsest level that the picture looks up of a filtered map of this size.
int blur_last_level(const BlurSettings *settings, const Views *views,
                    const int size[2]);

// Sets the uniforms of these files.
void blur_set_lookup(const Blur *blur, const Views *views, GLuint program);

// Filters every layer whole, of moments that moments_dump has drawn whole, and
// writes the result, layer L as directory/blurred.L.exr; see mips_dump for the
// rest.
void blur_dump(Blur *blur, const MomentsMap *moments, const BlurPlan *plan,
               const char *directory);

// Compiles the shaders again; see gl_program_reload.
bool blur_reload(Blur *blur);

void blur_destroy(Blur *blur);

#endif
