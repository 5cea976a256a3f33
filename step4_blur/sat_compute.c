#include "step4_blur/sat_compute.h"

// Rows or columns that one work group sums, as the shaders say.
enum { GROUP = 64 };

SatCompute sat_compute_create(ShaderFiles files)
{
    static const char *const rows[] = {"step3_moments/shaders/merge_raw.glsl",
                                       "step4_blur/shaders/map_texel.glsl",
                                       "step4_blur/shaders/sat_steps.glsl",
                                       "step4_blur/shaders/sat_rows.comp",
                                       NULL};
    static const char *const columns[] = {"step4_blur/shaders/sat_columns.comp",
                                          NULL};
    return (SatCompute){.rows = gl_compute_program(files, rows),
                        .columns = gl_compute_program(files, columns)};
}

// Sums the lines along one axis of every layer.
static void sum_lines(GLuint program, int axis, int layers, const Rect texels[],
                      const MapPlan *plan)
{
    for (int layer = 0; layer < layers; layer++) {
        const Rect *rect = &texels[layer];
        int lines = rect->high[1 - axis] - rect->low[1 - axis];
        if (!plan->layers[layer].draw || rect_is_empty(rect)) {
            continue;
        }
        glUniform1i(glGetUniformLocation(program, "layer"), layer);
        glUniform2iv(glGetUniformLocation(program, "first"), 1, rect->low);
        glUniform2iv(glGetUniformLocation(program, "end"), 1, rect->high);
        glDispatchCompute((GLuint)((lines + GROUP - 1) / GROUP), 1, 1);
    }
}

void sat_compute_apply(const SatCompute *compute, GLuint map, GLuint table,
                       int layers, GLuint steps, const Rect texels[],
                       const MapPlan *plan)
{
    GLuint rows = compute->rows.id;
    glBindImageTexture(0, table, 0, GL_TRUE, 0, GL_READ_WRITE, GL_RG32UI);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, map);
    glUseProgram(rows);
    glUniform1i(glGetUniformLocation(rows, "map"), 0);
    glUniform1ui(glGetUniformLocation(rows, "steps"), steps);
    sum_lines(rows, 0, layers, texels, plan);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glUseProgram(compute->columns.id);
    sum_lines(compute->columns.id, 1, layers, texels, plan);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

bool sat_compute_reload(SatCompute *compute)
{
    return gl_program_reload(&compute->rows) &&
           gl_program_reload(&compute->columns);
}

void sat_compute_destroy(SatCompute *compute)
{
    gl_program_destroy(&compute->columns);
    gl_program_destroy(&compute->rows);
}
