// The averages that these settings make, in their order, and which moments they
// are fit for.
#include <stdio.h>  // snprintf
#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"
#include "step4_blur/techniques/kernels/kernels.h" // kernels_filters
#include "step4_blur/techniques/mips/mips.h"       // mips_count
#include "step4_blur/techniques/sat/sat.h"         // sat_steps
#include "step5_chebyshev/chebyshev.h"             // chebyshev_guard
#include "step5_chebyshev/techniques/guard/guard.h"
#include "step5_chebyshev/techniques/guard/guarded.h"

static struct {
    const char *why; // moments are central or raw
    Target told;     // the row of --plan
} state;

const char *const guarded_visibility[] = {
    "step3_moments/techniques/shared/merge_raw.glsl",
    "step5_chebyshev/techniques/guard/guard_raw.glsl",
    "step5_chebyshev/techniques/guard/bias_none.glsl",
    "step5_chebyshev/techniques/guard/visibility_guarded.glsl", NULL};

static bool is_half(const Frame *frame)
{
    return options_is(frame->options, "format", "rg16f");
}

static bool is_central(const Frame *frame)
{
    return options_is(frame->options, "moments", "central");
}

static bool is_automatic(const Frame *frame)
{
    const double *least = options_value(frame->options, "min-variance");
    return *least == OPTION_AUTO;
}

// In 16 bits raw moments have no variance left. In a mip-map chain they can
// lose so much (proof.md) that `auto` lights shadows near their casters. But a
// table sums raw moments, and the texture unit averages them.
static void check(Frame *frame)
{
    const OptionTable *options = frame->options;
    const char **moments = options_value(options, "moments");
    if (options_given(options, "moments")) {
        state.why = "--moments";
    } else if (options_on(options, "sat") ||
               options_is(options, "sampler", "hardware")) {
        state.why = "only raw ones can be summed or averaged";
    } else if (is_half(frame)) {
        state.why = "--format rg16f: raw ones need 32 bits";
        *moments = "central";
    } else if (options_on(options, "mips")) {
        state.why = "raw ones lose too much in mip-maps";
        *moments = "central";
    } else {
        state.why = "raw ones lose little enough";
    }
}

// Whether the lesson's chebyshev_guard() knows every rounding.
static bool is_plain(const Frame *frame)
{
    const OptionTable *options = frame->options;
    return !is_central(frame) && !is_half(frame) &&
           options_integer(frame->options, "msaa") == 1 &&
           !options_on(options, "mips") && !options_on(options, "sat") &&
           !options_is(options, "blur", "boxes");
}

// One filter of the blur. Its weights are rounded, each by a part of itself: so
// is their sum. Running boxes round no more often: a term meets as many
// additions, and the division in place of the weight.
static void add_filter(GuardChain *chain, const int sides[2])
{
    float weights[KERNELS_MAX_WIDTH];
    kernels_weights(sides, weights);
    guard_add(chain, (GuardPass){.taps = sides[0] + 1 + sides[1],
                                 .heaviest = (double)weights[sides[0]],
                                 .defect = 0x1p-24,
                                 .stored = true});
}

// Both axes of the blur.
static void add_blur(GuardChain *chain, const Frame *frame)
{
    KernelSides filters[KERNELS_MAX_FILTERS];
    int count = kernels_filters(frame, filters);
    for (int i = 0; i < 2 * count; i++) {
        add_filter(chain, filters[i % count].sides);
    }
}

// The coarsest level, for which there are the most passes; then between two
// levels, then the taps along the pixel or over the penumbra.
static void add_levels(GuardChain *chain, const Frame *frame)
{
    int factor = options_integer(frame->options, "downsample");
    const int size[2] = {frame->settings.map_size[0] / factor,
                         frame->settings.map_size[1] / factor};
    int lookups = options_on(frame->options, "soft")
                      ? GUARDED_SOFT_TAPS
                      : options_integer(frame->options, "anisotropy");
    for (int level = 1; level < mips_count(size); level++) {
        guard_add(chain, (GuardPass){
                             .taps = 16, .heaviest = 9.0 / 64, .stored = true});
    }
    guard_add_bilinear(chain);
    guard_add(chain, (GuardPass){.two = true});
    if (lookups > 1) {
        guard_add_box(chain, lookups);
        chain->passes[chain->count - 1].stored = false;
    }
}

static ChainNumbers numbers_of_chain(const Frame *frame)
{
    GuardChain chain = {.central = is_central(frame)};
    int samples = options_integer(frame->options, "msaa");
    int factor = options_integer(frame->options, "downsample");
    if (is_half(frame)) {
        // Raw moments are left to the driver, which may cut them off.
        chain.store_roundoff = chain.central ? 0x1p-11 : 0x1p-10;
        chain.store_tiny = chain.central ? 0x1p-25 : 0x1p-24;
    }
    if (samples > 1) {
        guard_add_box(&chain, samples);
    }
    if (factor > 1) {
        guard_add_box(&chain, factor * factor);
    }
    if (options_on(frame->options, "sat")) {
        int width = 2 * options_integer(frame->options, "radius") + 1;
        chain.table_error = 0.5 / sat_steps(width) + 24 * 0x1p-24;
        return guard_numbers(&chain);
    }
    add_blur(&chain, frame);
    if (options_on(frame->options, "mips")) {
        add_levels(&chain, frame);
    } else {
        guard_add_bilinear(&chain);
    }
    return guard_numbers(&chain);
}

static ChainNumbers find_numbers(const Frame *frame)
{
    if (!is_plain(frame)) {
        return numbers_of_chain(frame);
    }
    GuardNumbers plain =
        chebyshev_guard(options_integer(frame->options, "radius"),
                        options_integer(frame->options, "downsample"));
    return (ChainNumbers){.variance = {plain.variance[0], plain.variance[1]},
                          .mean = {plain.mean[0], plain.mean[1]}};
}

static void put_constants(Frame *frame)
{
    ChainNumbers numbers = find_numbers(frame);
    char text[256];
    snprintf(text, sizeof text,
             "const float chain_spread = %.9g;"
             "const vec2 chain_variance = vec2(%.9g, %.9g), "
             "chain_mean = vec2(%.9g, %.9g);",
             (double)numbers.spread, (double)numbers.variance[0],
             (double)numbers.variance[1], (double)numbers.mean[0],
             (double)numbers.mean[1]);
    gl_put_in_front(&frame->shaders, text);
}

// Whether the picture reads the lesson's visibility.glsl, and so none of the
// guard's files: none has taken its place, of whatever technique.
static bool lesson_stays(const Frame *frame)
{
    static const char *const names[] = {
        "step5_chebyshev/shaders/visibility.glsl", NULL};
    const char *files[PROGRAM_MAX_FILES + 1];
    gl_find_files(&frame->shaders, names, files);
    return strcmp(files[0], names[0]) == 0;
}

static bool prepare(Frame *frame)
{
    static const char *const constant[] = {
        "step5_chebyshev/techniques/guard/guard_constant.glsl", NULL};
    static const char *const central[] = {
        "step5_chebyshev/techniques/guard/guard_central.glsl", NULL};
    if (!is_plain(frame)) {
        gl_put_instead(&frame->shaders,
                       "step5_chebyshev/shaders/visibility.glsl",
                       guarded_visibility);
    }
    if (!is_automatic(frame)) {
        gl_put_instead(&frame->shaders, guarded_visibility[1], constant);
    } else if (is_central(frame)) {
        gl_put_instead(&frame->shaders, guarded_visibility[1], central);
    }
    if (!lesson_stays(frame)) {
        put_constants(frame);
    }
    return true;
}

static void create(Frame *frame, Picture *picture)
{
    (void)picture;
    state.told = (Target){.pass = "central moments",
                          .why = state.why,
                          .kind = TARGET_NOTHING,
                          .idle = !is_central(frame)};
    target_add(&frame->targets, &state.told);
}

const Technique chebyshev_guarded = {
    .check = check, .prepare = prepare, .create = create};
