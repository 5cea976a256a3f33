#include "step4_blur/techniques/kernels/kernels.h"

#include <math.h>   // exp
#include <stdlib.h> // free
#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h" // die_usage
#include "step4_blur/blur.h"                 // blur_constants
#include "step4_blur/techniques/kernels/running_box.h"

// The published filter of 7 taps.
enum { BINOMIAL_RADIUS = 3 };

// Up to this radius fragments blur, with the lesson's own shader. (Running
// boxes take about half as long there, too.)
enum { FRAGMENTS_RADIUS = 3 };

static struct Settings {
    const char *kernel; // none, box, boxes, gaussian or binomial
    const char *by;     // what blurs: auto, compute or fragments
} settings = {"box", "auto"};

static struct {
    bool running; // boxes in compute shaders
    KernelSides filters[KERNELS_MAX_FILTERS];
    int count;
    Program *programs[2 * KERNELS_MAX_FILTERS];
    Target passes[2 * KERNELS_MAX_FILTERS]; // all along u, then all along v
} state;

static const Option options[] = {
    {.name = "blur",
     .kind = OPTION_CHOICE,
     .offset = offsetof(struct Settings, kernel),
     .choices = "none,box,boxes,gaussian,binomial",
     .help = "the filter's kernel; boxes: three boxes in a row; the binomial "
             "one is 7 texels wide"},
    {.name = "blur-by",
     .kind = OPTION_CHOICE,
     .offset = offsetof(struct Settings, by),
     .choices = "auto,compute,fragments",
     .help = "what blurs: running boxes in compute shaders, whose time does "
             "not grow with the radius, where the driver has them, or "
             "fragments"},
    {0},
};

static bool is_kernel(const char *name)
{
    return strcmp(settings.kernel, name) == 0;
}

static bool is_boxes(void)
{
    return is_kernel("box") || is_kernel("boxes");
}

static int radius_of(const Frame *frame)
{
    return options_integer(frame->options, "radius");
}

// A box of an even width has its middle half a texel from a texel's: two of
// them, one to each side, make up for it. The first box is of odd width.
static int three_boxes(int radius, KernelSides filters[KERNELS_MAX_FILTERS])
{
    int odd = (radius + 1) / 3; // to each side; the others share what is left
    int left = radius - odd;
    int count = 0;
    if (odd > 0) {
        filters[count++] = (KernelSides){{odd, odd}};
    }
    filters[count++] = (KernelSides){{left / 2, left - left / 2}};
    filters[count++] = (KernelSides){{left - left / 2, left / 2}};
    return count;
}

int kernels_filters(const Frame *frame,
                    KernelSides filters[KERNELS_MAX_FILTERS])
{
    int radius = radius_of(frame);
    if (radius == 0) {
        return 0;
    }
    if (is_kernel("boxes")) {
        return three_boxes(radius, filters);
    }
    filters[0] = (KernelSides){{radius, radius}};
    return 1;
}

static double kernel_weight(int radius, int offset)
{
    double weight = 1; // box, and each of several boxes
    if (is_kernel("gaussian")) {
        double deviation = radius / 3.0;
        weight = exp(-0.5 * offset * offset / (deviation * deviation));
    } else if (is_kernel("binomial")) {
        // 2 radius over (radius + offset), as a product.
        for (int i = 1; i <= radius + offset; i++) {
            weight *= (double)(2 * radius + 1 - i) / i;
        }
    }
    return weight;
}

void kernels_weights(const int sides[2], float weights[])
{
    double sum = 0;
    for (int i = -sides[0]; i <= sides[1]; i++) {
        sum += kernel_weight(sides[0], i);
    }
    for (int i = -sides[0]; i <= sides[1]; i++) {
        weights[i + sides[0]] = (float)(kernel_weight(sides[0], i) / sum);
    }
}

// Running boxes keep sums, which 16-bit floats cannot.
static bool can_run(const Frame *frame)
{
    return is_boxes() && !options_is(frame->options, "format", "rg16f");
}

static void check_compute(const Frame *frame, int radius)
{
    const char *idle =
        options_on(frame->options, "sat") ? "--sat averages in place of a blur"
        : radius == 0 ? "--blur none or --radius 0 leaves nothing to blur"
                      : NULL;
    if (idle != NULL && options_given(frame->options, "blur-by")) {
        die_usage("--blur-by %s says what blurs, and %s: drop one of them",
                  settings.by, idle);
    }
    if (strcmp(settings.by, "compute") == 0 && !can_run(frame)) {
        const char *const *format = options_value(frame->options, "format");
        die_usage("--blur-by compute moves boxes of 32-bit floats, not --blur "
                  "%s of --format %s: drop one of them",
                  settings.kernel, *format);
    }
}

// No kernel is a blur of radius 0, for which the lesson has no pass.
static void check(Frame *frame)
{
    int *radius = options_value(frame->options, "radius");
    bool given = options_given(frame->options, "radius");
    if (is_kernel("none") && *radius > 0 && given) {
        die_usage("--radius %d contradicts --blur none: drop one of them",
                  *radius);
    }
    if (is_kernel("binomial") && *radius != BINOMIAL_RADIUS) {
        die_usage("--radius %d contradicts --blur binomial, whose radius is "
                  "%d: drop one of them",
                  *radius, BINOMIAL_RADIUS);
    }
    if (is_kernel("none")) {
        *radius = 0;
    }
    check_compute(frame, *radius);
}

static bool runs(const Frame *frame)
{
    if (strcmp(settings.by, "compute") == 0 && !gl_has_compute()) {
        die_usage("--blur-by compute needs OpenGL 4.3, and this driver has no "
                  "compute shaders: drop --blur-by");
    }
    if (strcmp(settings.by, "auto") != 0) {
        return strcmp(settings.by, "compute") == 0;
    }
    return gl_has_compute() && can_run(frame) &&
           radius_of(frame) > FRAGMENTS_RADIUS;
}

static double variance_of(const int sides[2])
{
    float weights[KERNELS_MAX_WIDTH];
    double mean = 0, square = 0;
    kernels_weights(sides, weights);
    for (int i = -sides[0]; i <= sides[1]; i++) {
        mean += (double)weights[i + sides[0]] * i;
        square += (double)weights[i + sides[0]] * i * i;
    }
    return square - mean * mean;
}

static bool prepare(Frame *frame)
{
    const int *texel = options_value(frame->options, "downsample");
    double variance = 0;
    state.running = runs(frame);
    state.count = kernels_filters(frame, state.filters);
    if (state.count == 0 || options_on(frame->options, "sat") ||
        (is_kernel("box") && !state.running)) {
        return false;
    }
    for (int i = 0; i < state.count; i++) {
        variance += variance_of(state.filters[i].sides);
    }
    if (frame->lookups.spread > 0) {
        frame->lookups.spread = *texel * *texel * variance;
    }
    return true;
}

// As the lesson's shader wants them: as many to both sides, some of no weight.
static Program *fragments_program(Frame *frame, const int sides[2], int axis)
{
    static const char *const files[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step4_blur/shaders/map_texel.glsl", "step4_blur/shaders/blur.frag",
        NULL};
    float weights[KERNELS_MAX_WIDTH] = {0};
    int radius = sides[0] > sides[1] ? sides[0] : sides[1];
    kernels_weights(sides, &weights[radius - sides[0]]);
    char *constants = blur_constants(radius, weights, axis);
    Program *program = gl_program(&frame->shaders, constants, files);
    free(constants);
    return program;
}

static void create_pass(Frame *frame, int i, Target *source,
                        const Target *before)
{
    int axis = i / state.count;
    const int *sides = state.filters[i % state.count].sides;
    Target *pass = &state.passes[i];
    *pass =
        target_reading(source, axis == 0 ? "blur along u" : "blur along v", 1);
    pass->why =
        state.running ? "by running boxes in compute shaders" : "by fragments";
    pass->shares = i < 2 ? NULL : &state.passes[i % 2];
    pass->reach[axis] = sides[0] > sides[1] ? sides[0] : sides[1];
    state.programs[i] = state.running
                            ? running_box_program(&frame->shaders, sides)
                            : fragments_program(frame, sides, axis);
    target_add_before(&frame->targets, pass, before);
}

// All filters along u, then all along v: an even number, by turns between two
// textures, in place of the lesson's two passes.
static void create(Frame *frame, Picture *picture)
{
    Target *along_u = targets_find(&frame->targets, "blur along u");
    Target *along_v = targets_find(&frame->targets, "blur along v");
    Target *source = along_u->reads;
    (void)picture;
    for (int i = 0; i < 2 * state.count; i++) {
        create_pass(frame, i, source, along_u);
        source = &state.passes[i];
    }
    target_take_place(along_u, source);
    target_take_place(along_v, source);
}

static void after(const Frame *frame)
{
    for (int i = 0; i < 2 * state.count; i++) {
        if (state.running) {
            running_box_apply(state.programs[i], &state.passes[i],
                              i / state.count,
                              state.filters[i % state.count].sides);
        } else {
            frame_filter(frame, state.programs[i], &state.passes[i]);
        }
    }
}

const Technique blur_kernels = {.options = options,
                                .settings = &settings,
                                .check = check,
                                .prepare = prepare,
                                .create = create,
                                .after = after,
                                .pass = "blur"};
