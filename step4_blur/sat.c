#include "step4_blur/sat.h"

#include <stdint.h> // UINT32_MAX
#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h"    // die_usage
#include "step1_shadowmap/base/picture/dump.h"  // dump_layers
#include "step1_shadowmap/base/system/memory.h" // memory_check
#include "step1_shadowmap/shadow_map.h"         // shadow_map_depths

// Integers cannot be filtered, so the lookup reads single texels.
static GLuint create_table(const Sat *sat)
{
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RG32UI, sat->width, sat->height,
                 sat->layers, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, NULL);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

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

static Program create_program(ShaderFiles files, const char *const fragment[])
{
    const char *vertex[] = {"step1_shadowmap/shaders/fullscreen.vert", NULL};
    return gl_program(files, vertex, fragment);
}

enum { TEXEL_BYTES = 2 * sizeof(GLuint) };

static void add_table(Sat *sat, int i)
{
    size_t bytes = (size_t)sat->width * (size_t)sat->height *
                   (size_t)sat->layers * TEXEL_BYTES;
    memory_check(bytes, "a table of %dx%d texels", sat->width, sat->height);
    sat->textures[i] = create_table(sat);
    sat->bytes += bytes;
}

// Recursive doubling reads one table while it draws the other.
static void create_fragments(Sat *sat)
{
    static const char *const start[] = {"step3_moments/shaders/merge_raw.glsl",
                                        "step4_blur/shaders/map_texel.glsl",
                                        "step4_blur/shaders/sat_steps.glsl",
                                        "step4_blur/shaders/sat_start.frag",
                                        NULL};
    static const char *const sum[] = {"step4_blur/shaders/sat_sum.frag", NULL};
    sat->start_program = create_program(sat->files, start);
    sat->sum_program = create_program(sat->files, sum);
    add_table(sat, 1);
    for (int i = 0; i < 2; i++) {
        for (int layer = 0; layer < sat->layers; layer++) {
            sat->framebuffers[i][layer] =
                gl_layer_framebuffer(sat->textures[i], layer, 0);
        }
    }
}

bool sat_uses_compute(const char *by)
{
    return gl_has_compute() && strcmp(by, "fragments") != 0;
}

Sat sat_create(ShaderFiles files, const int size[2], int layers, int radius,
               const char *by)
{
    Sat sat = {.files = files,
               .width = size[0],
               .height = size[1],
               .layers = layers,
               .box_width = 2 * radius + 1,
               .steps = count_steps(2 * radius + 1)};
    bool compute = sat_uses_compute(by);
    if (strcmp(by, "compute") == 0 && !compute) {
        die_usage("--sat-by compute needs OpenGL 4.3, and this driver has no "
                  "compute shaders: drop --sat-by");
    }
    add_table(&sat, 0);
    if (compute) {
        sat.compute = sat_compute_create(files);
    } else {
        create_fragments(&sat);
    }
    return sat;
}

// What of each layer is summed.
typedef struct Part {
    const Rect *texels; // by layer
    const MapPlan *plan;
    GLuint empty_vao;
} Part;

// Draws the layers of table `target`.
static void draw_layers(const Sat *sat, GLuint program, GLuint source,
                        int target, const Part *part)
{
    glBindTexture(GL_TEXTURE_2D_ARRAY, source);
    for (int layer = 0; layer < sat->layers; layer++) {
        const Rect *texels = &part->texels[layer];
        if (!part->plan->layers[layer].draw) {
            continue;
        }
        gl_limit(texels);
        glBindFramebuffer(GL_FRAMEBUFFER, sat->framebuffers[target][layer]);
        glUniform1i(glGetUniformLocation(program, "layer"), layer);
        glUniform2iv(glGetUniformLocation(program, "first"), 1, texels->low);
        gl_draw_fullscreen(part->empty_vao);
    }
    gl_unlimit();
}

// Sums along one axis; takes and returns the index of the newer table.
static int sum_axis(const Sat *sat, int newer, int axis, const Part *part)
{
    GLuint program = sat->sum_program.id;
    int side = axis == 0 ? sat->width : sat->height;
    glUniform2i(glGetUniformLocation(program, "axis"), 1 - axis, axis);
    for (int stride = 1; stride < side; stride *= 4) {
        glUniform1i(glGetUniformLocation(program, "stride"), stride);
        draw_layers(sat, program, sat->textures[newer], 1 - newer, part);
        newer = 1 - newer;
    }
    return newer;
}

// How often sums are doubled twice along an axis.
static size_t count_doublings(int side)
{
    size_t count = 0;
    for (int stride = 1; stride < side; stride *= 4) {
        count++;
    }
    return count;
}

void sat_touch(const Sat *sat, size_t texels, size_t map_texel_bytes,
               Touched *touched)
{
    bool compute = sat->compute.rows.id != 0;
    size_t passes =
        compute ? 1
                : count_doublings(sat->width) + count_doublings(sat->height);
    touch(touched, texels, map_texel_bytes + TEXEL_BYTES);
    touch(touched, passes * texels, 2 * TEXEL_BYTES);
}

GLuint sat_apply(const Sat *sat, GLuint map, GLuint empty_vao,
                 const Rect texels[], const MapPlan *plan)
{
    const Part part = {texels, plan, empty_vao};
    if (sat->compute.rows.id != 0) {
        sat_compute_apply(&sat->compute, map, sat->textures[0], sat->layers,
                          sat->steps, texels, plan);
        return sat->textures[0];
    }
    GLuint start = sat->start_program.id;
    glViewport(0, 0, sat->width, sat->height);
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(start);
    glUniform1i(glGetUniformLocation(start, "map"), 0);
    glUniform1ui(glGetUniformLocation(start, "steps"), sat->steps);
    draw_layers(sat, start, map, 0, &part);
    glUseProgram(sat->sum_program.id);
    glUniform1i(glGetUniformLocation(sat->sum_program.id, "table"), 0);
    int newer = sum_axis(sat, 0, 0, &part);
    newer = sum_axis(sat, newer, 1, &part);
    return sat->textures[newer];
}

void sat_set_lookup(const Sat *sat, GLuint program)
{
    glUniform1ui(glGetUniformLocation(program, "steps"), sat->steps);
    glUniform1f(glGetUniformLocation(program, "box_width"),
                (float)sat->box_width);
}

void sat_dump(const Sat *sat, GLuint table, GLuint empty_vao,
              const char *directory)
{
    GLuint boxes = gl_texture_array(GL_RG32F, sat->width, sat->height,
                                    sat->layers, shadow_map_depths);
    static const char *const boxed[] = {"step4_blur/shaders/sat_box.glsl",
                                        "step4_blur/shaders/sat_dump.frag",
                                        NULL};
    Program program = create_program(sat->files, boxed);
    glDisable(GL_DEPTH_TEST);
    glViewport(0, 0, sat->width, sat->height);
    glUseProgram(program.id);
    glUniform1i(glGetUniformLocation(program.id, "shadow_map"), 0);
    sat_set_lookup(sat, program.id);
    glBindTexture(GL_TEXTURE_2D_ARRAY, table);
    for (int layer = 0; layer < sat->layers; layer++) {
        GLuint framebuffer = gl_layer_framebuffer(boxes, layer, 0);
        glUniform1i(glGetUniformLocation(program.id, "layer"), layer);
        gl_draw_fullscreen(empty_vao);
        glDeleteFramebuffers(1, &framebuffer);
    }
    dump_layers(directory, "blurred", boxes, sat->width, sat->height,
                sat->layers, 2);
    gl_program_destroy(&program);
    glDeleteTextures(1, &boxes);
}

bool sat_reload(Sat *sat)
{
    return gl_program_reload(&sat->start_program) &&
           gl_program_reload(&sat->sum_program) &&
           sat_compute_reload(&sat->compute);
}

void sat_destroy(Sat *sat)
{
    for (int i = 0; i < 2; i++) {
        glDeleteFramebuffers(sat->layers, sat->framebuffers[i]);
    }
    glDeleteTextures(2, sat->textures);
    sat_compute_destroy(&sat->compute);
    gl_program_destroy(&sat->sum_program);
    gl_program_destroy(&sat->start_program);
    *sat = (Sat){.width = 0};
}
