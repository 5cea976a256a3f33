// Step 4: the moments, filtered before anyone looks them up.
#ifndef STEP4_BLUR_H
#define STEP4_BLUR_H

#include "step3_moments/moments.h" // Moments
#include "step4_blur/mips.h"       // Mips
#include "step4_blur/sat.h"        // Sat

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

// The variance of the weights of a filtered texel, in texels of the full map;
// of a lookup that is the mean of them about the receiver's own place. 0: it
// may be another, or about another place.
double blur_spread(const BlurSettings *settings);

// The lookups of a picture that compares with biased means, see bias_lookups.
Lookups blur_lookups(const BlurSettings *settings,
                     const MomentsSettings *moments, const BiasSettings *bias);

typedef struct Blur {
    const BlurSettings *settings;
    Target *source; // the moments
    Target small;   // downsampled; with mips alone: copied
    Program *downsample;
    bool running; // the blur is of running boxes in compute shaders
    BlurSides filters[BLUR_MAX_FILTERS]; // none where the radius is 0
    int filter_count;
    Program *programs[BLUR_MAX_FILTERS];
    Target passes[2 * BLUR_MAX_FILTERS]; // all along u, then all along v
    Mips mips;                           // of the result
    Sat sat;                             // in place of the blur
    Target result;       // what the picture looks up, filtered or not
    Target not_asked[4]; // passes that there are not, for --plan
} Blur;

// Keeps the pointers to the settings and to the moments' target.
void blur_create(Blur *blur, Frame *frame, const BlurSettings *settings,
                 Moments *moments);

void blur_apply(Blur *blur, const Frame *frame);

enum { BLUR_MAX_SHADERS = 8 };

// The one of them that looks up a table's box.
extern const char blur_sat_lookup[];

// The shader files of a picture that looks the result up: those that define
// vec2 moments_at(Receiver), then `visibility`, which uses it, then NULL. What
// was not asked for is not among them. Up to BLUR_MAX_SHADERS with the NULL.
void blur_picture_shaders(const BlurSettings *settings,
                          const MomentsSettings *moments,
                          const char *visibility, const char *files[]);

// The coarsest level that the picture looks up of a chain of so many.
int blur_last_level(const BlurSettings *settings, const Views *views,
                    int levels);

// Sets the uniforms of these files. The program is in use.
void blur_set_lookup(const Blur *blur, const Frame *frame, GLuint program);

#endif
