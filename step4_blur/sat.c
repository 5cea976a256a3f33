#include "step4_blur/sat.h"

#include <stdint.h> // UINT32_MAX
#include <string.h> // strcmp

#include "step1_shadowmap/base/picture/dump.h" // dump_target
#include "step1_shadowmap/base/system/die.h"   // die_usage

// Integers cannot be filtered, so the lookup reads single texels.
static const Sampling single = {GL_NEAREST, {0, 0, 0, 0}};

// As many as a box's sum can hold in 32 bits when all of it is 1. A power of
// two, by which floats are multiplied and divided without rounding.
static GLuint count_steps(int box_width)
{
    double most = UINT32_MAX / ((double)box_width * box_width);
    GLuint steps = 1;
    while (steps <= most / 2) {
        steps *= 2;
    }
    return steps;
}

static Program *create_program(Shaders *shaders, const char *const fragment[])
{
    static const char *const vertex[] = {
        "step1_shadowmap/shaders/fullscreen.vert", NULL};
    return gl_program(shaders, NULL, vertex, fragment);
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
static Target *create_fragments(Sat *sat, Frame *frame, const Target *map)
{
    static const char *const start[] = {"step3_moments/shaders/merge_raw.glsl",
                                        "step4_blur/shaders/map_texel.glsl",
                                        "step4_blur/shaders/sat_steps.glsl",
                                        "step4_blur/shaders/sat_start.frag",
                                        NULL};
    static const char *const sum[] = {"step4_blur/shaders/sat_sum.frag", NULL};
    sat->start = create_program(&frame->shaders, start);
    sat->sum = create_program(&frame->shaders, sum);
    sat->doublings[0] = count_doublings(map->width);
    sat->doublings[1] = count_doublings(map->height);
    int last = (sat->doublings[0] + sat->doublings[1] + 1) % 2;
    sat->sums[1 - last] = create_table(map, &sat->table);
    sat->sums[last] = create_table(map, &sat->sums[1 - last]);
    sat->sums[1].shares = &sat->table;
    target_add(&frame->targets, &sat->sums[1 - last]);
    target_add(&frame->targets, &sat->sums[last]);
    return &sat->sums[last];
}

static Target *create_compute(Sat *sat, Frame *frame, const Target *map)
{
    sat->compute = sat_compute_create(&frame->shaders);
    sat->sums[0] = create_table(map, &sat->table);
    sat->sums[0].shares = &sat->table;
    target_add(&frame->targets, &sat->sums[0]);
    return &sat->sums[0];
}

static bool uses_compute(const char *by)
{
    return gl_has_compute() && strcmp(by, "fragments") != 0;
}

Target *sat_create(Sat *sat, Frame *frame, Target *map, int radius,
                   const char *by)
{
    bool compute = uses_compute(by);
    if (strcmp(by, "compute") == 0 && !compute) {
        die_usage("--sat-by compute needs OpenGL 4.3, and this driver has no "
                  "compute shaders: drop --sat-by");
    }
    sat->box_width = 2 * radius + 1;
    sat->steps = count_steps(sat->box_width);
    sat->table = create_table(map, map);
    sat->table.pass = "summed-area table";
    sat->table.why = compute ? "by compute shaders" : "by fragments";
    target_add(&frame->targets, &sat->table);
    sat->newest = compute ? create_compute(sat, frame, map)
                          : create_fragments(sat, frame, map);
    return sat->newest;
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
static Target *sum_axis(Sat *sat, const Frame *frame, GLuint program, int axis,
                        Target *newer)
{
    int stride = 1;
    glUniform2i(glGetUniformLocation(program, "axis"), 1 - axis, axis);
    for (int i = 0; i < sat->doublings[axis]; i++) {
        Target *next = &sat->sums[newer == &sat->sums[0] ? 1 : 0];
        glUniform1i(glGetUniformLocation(program, "stride"), stride);
        draw_layers(frame, program, target_texture(newer), next);
        newer = next;
        stride *= 4;
    }
    return newer;
}

static void sum_fragments(Sat *sat, const Frame *frame)
{
    GLuint start = gl_use(sat->start);
    glUniform1i(glGetUniformLocation(start, "map"), 0);
    glUniform1ui(glGetUniformLocation(start, "steps"), sat->steps);
    draw_layers(frame, start, target_texture(sat->table.reads), &sat->table);
    GLuint sum = gl_use(sat->sum);
    glUniform1i(glGetUniformLocation(sum, "table"), 0);
    Target *newer = sum_axis(sat, frame, sum, 0, &sat->table);
    sum_axis(sat, frame, sum, 1, newer);
}

void sat_set_lookup(const Sat *sat, GLuint program)
{
    glUniform1ui(glGetUniformLocation(program, "steps"), sat->steps);
    glUniform1f(glGetUniformLocation(program, "box_width"),
                (float)sat->box_width);
}

static void dump(const Sat *sat, const Frame *frame, GLuint table)
{
    static const char *const boxed[] = {"step4_blur/shaders/sat_box.glsl",
                                        "step4_blur/shaders/sat_dump.frag",
                                        NULL};
    Shaders shaders = {.directory = frame->shaders.directory};
    Targets targets = {.count = 0};
    Target boxes = create_table(&sat->table, NULL);
    boxes.pass = "boxes";
    boxes.file = "blurred";
    boxes.formats[0] = GL_RG32F;
    target_add(&targets, &boxes);
    GLuint program = gl_use(create_program(&shaders, boxed));
    glUniform1i(glGetUniformLocation(program, "shadow_map"), 0);
    sat_set_lookup(sat, program);
    draw_layers(frame, program, table, &boxes);
    dump_target(&boxes, frame->dump);
    targets_destroy(&targets);
    gl_destroy_programs(&shaders);
}

void sat_apply(Sat *sat, const Frame *frame)
{
    if (sat->start == NULL) {
        sat_compute_apply(&sat->compute, target_texture(sat->table.reads),
                          &sat->table, &sat->sums[0], sat->steps);
    } else {
        sum_fragments(sat, frame);
    }
    if (frame->dump != NULL) {
        dump(sat, frame, target_texture(sat->newest));
    }
}
