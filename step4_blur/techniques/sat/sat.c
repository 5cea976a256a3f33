// --sat: a summed-area table in place of the blur. A box of any width costs
// four lookups, so that the width may differ from pixel to pixel.
#include "step4_blur/techniques/sat/sat.h"

#include <stdint.h> // UINT32_MAX
#include <string.h> // strcmp

#include "step1_shadowmap/base/picture/dump.h"    // dump_target
#include "step1_shadowmap/base/picture/picture.h" // Picture
#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h" // die_usage
#include "step4_blur/techniques/sat/sat_compute.h"

static struct Settings {
    bool asked;
    const char *by; // what sums: auto, compute or fragments
} settings = {.by = "auto"};

static struct {
    SatCompute compute; // in place of the two programs
    Program *start;     // NULL: compute shaders sum
    Program *sum;
    Target table; // of two 32-bit whole numbers: the map's, or sums along rows
    Target sums[2];   // of both axes; with fragments they take turns
    Target *newest;   // that is drawn last
    int doublings[2]; // how often sums are doubled twice along an axis
    int box_width;    // texels, 2 radius + 1
    GLuint steps;     // what 1.0 is in whole numbers
    Target no_blur;   // a row of --plan
} state;

static const Option options[] = {
    {.name = "sat",
     .kind = OPTION_FLAG,
     .offset = offsetof(struct Settings, asked),
     .help = "average the box from a summed-area table, in constant time"},
    {.name = "sat-by",
     .kind = OPTION_CHOICE,
     .offset = offsetof(struct Settings, by),
     .choices = "auto,compute,fragments",
     .help = "what sums the table: running sums in compute shaders, where the "
             "driver has them, or recursive doubling in fragments"},
    {0},
};

static void check(Frame *frame)
{
    const char *const *kernel = options_value(frame->options, "blur");
    if (options_given(frame->options, "sat-by") && !settings.asked) {
        die_usage("--sat-by %s needs --sat: add --sat or drop --sat-by",
                  settings.by);
    }
    if (!settings.asked) {
        return;
    }
    if (options_on(frame->options, "mips")) {
        die_usage("--sat contradicts --mips: drop one of them");
    }
    if (strcmp(*kernel, "box") != 0) {
        die_usage("--sat averages a box, not --blur %s: drop one of them",
                  *kernel);
    }
    if (options_is(frame->options, "moments", "central")) {
        die_usage("--sat sums moments, and --moments central are no sums: "
                  "drop one of them");
    }
}

// Integers cannot be filtered, so the lookup reads single texels.
static const Sampling single = {GL_NEAREST, {0, 0, 0, 0}};

// As many as a box's sum can hold in 32 bits when all of it is 1. A power of
// two, by which floats are multiplied and divided without rounding.
GLuint sat_steps(int box_width)
{
    double most = UINT32_MAX / ((double)box_width * box_width);
    GLuint steps = 1;
    while (steps <= most / 2) {
        steps *= 2;
    }
    return steps;
}

static Target create_table(const Target *map, Target *reads)
{
    return (Target){.kind = TARGET_LAYERS,
                    .width = map->width,
                    .height = map->height,
                    .layers = map->layers,
                    .formats = {GL_RG32UI},
                    .sampling = single,
                    .reads = reads,
                    .scale = 1};
}

static int count_doublings(int side)
{
    int count = 0;
    for (int stride = 1; stride < side; stride *= 4) {
        count++;
    }
    return count;
}

// Recursive doubling reads one table while it draws the other. Returns the one
// that is drawn last.
static Target *create_fragments(Frame *frame, const Target *map)
{
    static const char *const start[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step4_blur/shaders/map_texel.glsl",
        "step4_blur/techniques/sat/sat_steps.glsl",
        "step4_blur/techniques/sat/sat_start.frag", NULL};
    static const char *const sum[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step4_blur/techniques/sat/sat_sum.frag", NULL};
    state.start = gl_program(&frame->shaders, NULL, start);
    state.sum = gl_program(&frame->shaders, NULL, sum);
    state.doublings[0] = count_doublings(map->width);
    state.doublings[1] = count_doublings(map->height);
    int last = (state.doublings[0] + state.doublings[1] + 1) % 2;
    state.sums[1 - last] = create_table(map, &state.table);
    state.sums[last] = create_table(map, &state.sums[1 - last]);
    state.sums[1].shares = &state.table;
    target_add(&frame->targets, &state.sums[1 - last]);
    target_add(&frame->targets, &state.sums[last]);
    return &state.sums[last];
}

static Target *create_compute(Frame *frame, const Target *map)
{
    state.compute = sat_compute_create(&frame->shaders);
    state.sums[0] = create_table(map, &state.table);
    state.sums[0].shares = &state.table;
    target_add(&frame->targets, &state.sums[0]);
    return &state.sums[0];
}

static bool uses_compute(void)
{
    return gl_has_compute() && strcmp(settings.by, "fragments") != 0;
}

// A lookup's box is about the receiver's own place.
static bool prepare(Frame *frame)
{
    static const char *const lookup[] = {
        "step4_blur/techniques/sat/sat_box.glsl",
        "step4_blur/techniques/sat/lookup_sat.glsl", NULL};
    if (!settings.asked) {
        return false;
    }
    if (strcmp(settings.by, "compute") == 0 && !gl_has_compute()) {
        die_usage("--sat-by compute needs OpenGL 4.3, and this driver has no "
                  "compute shaders: drop --sat-by");
    }
    gl_put_instead(&frame->shaders,
                   "step3_moments/shaders/lookup_bilinear.glsl", lookup);
    frame->lookups.kernel = 0;
    frame->lookups.spread = 0;
    return true;
}

// The table holds every box: whatever reads a pass of the lesson's blur reads
// what was to be blurred.
static Target *remove_blur(Frame *frame, Target *map)
{
    static const char *const passes[] = {"blur along v", "blur along u"};
    for (int i = 0; i < 2; i++) {
        Target *pass = targets_find(&frame->targets, passes[i]);
        if (pass != NULL) {
            target_take_place(pass, pass->reads);
        }
    }
    state.no_blur = (Target){.pass = "blur",
                             .why = "the table holds every box",
                             .kind = TARGET_NOTHING,
                             .idle = true};
    target_add(&frame->targets, &state.no_blur);
    return map;
}

// It has sums of the wanted texels alone: what is left of them or below counts
// as 0, so boxes within them come out the same to the last bit.
static void create(Frame *frame, Picture *picture)
{
    const int *radius = options_value(frame->options, "radius");
    bool compute = uses_compute();
    Target *map = remove_blur(frame, picture->map);
    map->file = NULL;
    map->looked_up = 0;
    state.box_width = 2 * *radius + 1;
    state.steps = sat_steps(state.box_width);
    state.table = create_table(map, map);
    state.table.pass = "summed-area table";
    state.table.why = compute ? "by compute shaders" : "by fragments";
    target_add(&frame->targets, &state.table);
    state.newest =
        compute ? create_compute(frame, map) : create_fragments(frame, map);
    state.newest->looked_up = *radius + 2; // just outside of the box too
    picture->map = state.newest;
}

// Draws the layers of a table.
static void draw_layers(const Frame *frame, GLuint program, GLuint source,
                        Target *target)
{
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, source);
    for (int layer = 0; layer < target->layers; layer++) {
        if (target_begin(target, layer)) {
            glUniform1i(glGetUniformLocation(program, "layer"), layer);
            glUniform2iv(glGetUniformLocation(program, "first"), 1,
                         target->layer[layer].wanted.low);
            gl_draw_fullscreen(frame->empty_vao);
        }
    }
}

// Sums along one axis; takes and returns the newer table.
static Target *sum_axis(const Frame *frame, GLuint program, int axis,
                        Target *newer)
{
    int stride = 1;
    glUniform2i(glGetUniformLocation(program, "axis"), 1 - axis, axis);
    for (int i = 0; i < state.doublings[axis]; i++) {
        Target *next = &state.sums[newer == &state.sums[0] ? 1 : 0];
        glUniform1i(glGetUniformLocation(program, "stride"), stride);
        draw_layers(frame, program, target_texture(newer), next);
        newer = next;
        stride *= 4;
    }
    return newer;
}

static void sum_fragments(const Frame *frame)
{
    GLuint start = gl_use(state.start);
    glUniform1i(glGetUniformLocation(start, "map"), 0);
    glUniform1ui(glGetUniformLocation(start, "steps"), state.steps);
    draw_layers(frame, start, target_texture(state.table.reads), &state.table);
    GLuint sum = gl_use(state.sum);
    glUniform1i(glGetUniformLocation(sum, "table"), 0);
    Target *newer = sum_axis(frame, sum, 0, &state.table);
    sum_axis(frame, sum, 1, newer);
}

static void set_lookup(GLuint program)
{
    glUniform1ui(glGetUniformLocation(program, "steps"), state.steps);
    glUniform1f(glGetUniformLocation(program, "box_width"),
                (float)state.box_width);
}

static void look(const Frame *frame, GLuint program)
{
    (void)frame;
    set_lookup(program);
}

// The box's mean at every texel of layer L becomes blurred.L.exr.
static void dump(const Frame *frame)
{
    static const char *const boxed[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step4_blur/techniques/sat/sat_box.glsl",
        "step4_blur/techniques/sat/sat_dump.frag", NULL};
    Shaders shaders = {.directory = frame->shaders.directory};
    Targets targets = {.count = 0};
    Target boxes = create_table(&state.table, NULL);
    boxes.pass = "boxes";
    boxes.file = "blurred";
    boxes.formats[0] = GL_RG32F;
    target_add(&targets, &boxes);
    GLuint program = gl_use(gl_program(&shaders, NULL, boxed));
    glUniform1i(glGetUniformLocation(program, "shadow_map"), 0);
    set_lookup(program);
    draw_layers(frame, program, target_texture(state.newest), &boxes);
    dump_target(&boxes, frame->dump);
    targets_destroy(&targets);
    gl_destroy_programs(&shaders);
}

static void after(const Frame *frame)
{
    Target *map = state.table.reads;
    GLuint texture = target_texture(map);
    Sampling nearest = map->sampling;
    nearest.filter = GL_NEAREST;
    GLuint sampler = gl_sampler(nearest);
    glBindSampler(0, sampler);
    if (state.start == NULL) {
        sat_compute_apply(&state.compute, texture, &state.table, &state.sums[0],
                          state.steps);
    } else {
        sum_fragments(frame);
    }
    if (frame->dump != NULL) {
        dump(frame);
    }
    glBindSampler(0, 0);
    glDeleteSamplers(1, &sampler);
}

const Technique blur_sat = {.options = options,
                            .settings = &settings,
                            .check = check,
                            .prepare = prepare,
                            .create = create,
                            .after = after,
                            .pass = "blur",
                            .look = look};
